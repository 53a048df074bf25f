// Descriptions of elements, and a patcher that makes the document agree with them. Elements that stay keep their
// identity, and with it the focus and the pointer: a picture can be redrawn under the reader's hand.

const NAMESPACES = {
  svg: "http://www.w3.org/2000/svg",
  math: "http://www.w3.org/1998/Math/MathML",
};

const described = new WeakMap();

/**
 * Describes an element. Children may be strings, descriptions, nested lists; null and false are left out.
 * @param {string} tag
 * @param {Object} attributes null, undefined and false remove an attribute, true writes it empty
 */
export function element(tag, attributes = {}, ...children) {
  const flat = children
    .flat(Infinity)
    .filter((child) => child !== null && child !== undefined && child !== false);
  return { tag, attributes, children: flat.map((child) => (typeof child === "object" ? child : `${child}`)) };
}

function create(parent, description) {
  if (typeof description === "string") return document.createTextNode(description);
  const inherited = parent.localName === "foreignObject" ? null : parent.namespaceURI;
  const created = document.createElementNS(NAMESPACES[description.tag] ?? inherited, description.tag);
  update(created, description);
  return created;
}

function update(node, description) {
  const before = described.get(node)?.attributes ?? {};
  const { attributes, children } = description;
  for (const name of Object.keys(before)) if (!(name in attributes)) node.removeAttribute(name);
  for (const [name, value] of Object.entries(attributes)) {
    // What the reader has typed or ticked is a property; attributes are only its first value.
    if (name === "checked" || name === "value" || name === "disabled" || name === "hidden") {
      if (node[name] !== value) node[name] = value;
      continue;
    }
    if (before[name] === value) continue;
    if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : `${value}`);
  }
  described.set(node, description);
  patch(node, children);
}

/** Makes the children of `parent` agree with the descriptions, reusing the elements that are there. */
export function patch(parent, children) {
  children.forEach((child, k) => {
    const old = parent.childNodes[k];
    if (old === undefined) parent.appendChild(create(parent, child));
    else if (typeof child === "string") {
      if (old.nodeType !== Node.TEXT_NODE) parent.replaceChild(create(parent, child), old);
      else if (old.data !== child) old.data = child;
    } else if (old.localName === child.tag) update(old, child);
    else parent.replaceChild(create(parent, child), old);
  });
  while (parent.childNodes.length > children.length) parent.removeChild(parent.lastChild);
}

/** The element with an id. */
export function byId(id) {
  return document.getElementById(id);
}

/** One reader's change from a keyboard: the next index in a list of `count` for an arrow key, or null. */
export function rove(key, index, count) {
  if (count === 0) return null;
  if (key === "ArrowRight" || key === "ArrowUp") return (index + 1) % count;
  if (key === "ArrowLeft" || key === "ArrowDown") return (index + count - 1) % count;
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  return null;
}
