// @ts-check
// Descriptions of elements, and a patcher that makes the document agree with them. Elements that stay keep their
// identity, and with it the focus and the pointer: a picture can be redrawn under the reader's hand.

/** @type {Record<string, string>} */
const NAMESPACES = {
  svg: "http://www.w3.org/2000/svg",
  math: "http://www.w3.org/1998/Math/MathML",
};

/** @type {WeakMap<Node, Description>} */
const described = new WeakMap();

/**
 * Describes an element. Children may be strings, descriptions, nested lists; null and false are left out.
 * @param {string} tag
 * @param {Attributes} attributes null, undefined and false remove an attribute, true writes it empty
 * @param {Content[]} children
 * @returns {Description}
 */
export function element(tag, attributes = {}, ...children) {
  const flat = /** @type {(Description | string | number)[]} */ (
    /** @type {unknown[]} */ (children)
      .flat(Infinity)
      .filter((child) => child !== null && child !== undefined && child !== false)
  );
  return { tag, attributes, children: flat.map((child) => (typeof child === "object" ? child : `${child}`)) };
}

/**
 * @param {Element} parent
 * @param {Description | string} description
 */
function create(parent, description) {
  if (typeof description === "string") return document.createTextNode(description);
  const inherited = parent.localName === "foreignObject" ? null : parent.namespaceURI;
  const created = document.createElementNS(NAMESPACES[description.tag] ?? inherited, description.tag);
  update(created, description);
  return created;
}

/**
 * @param {Element} node
 * @param {Description} description
 */
function update(node, description) {
  const before = described.get(node)?.attributes ?? {};
  const { attributes, children } = description;
  for (const name of Object.keys(before)) if (!(name in attributes)) node.removeAttribute(name);
  for (const [name, value] of Object.entries(attributes)) {
    // What the reader has typed or ticked is a property; attributes are only its first value.
    if (name === "checked" || name === "value" || name === "disabled" || name === "hidden") {
      const control = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (node));
      if (control[name] !== value) control[name] = value;
      continue;
    }
    if (before[name] === value) continue;
    if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : `${value}`);
  }
  described.set(node, description);
  patch(node, children);
}

/**
 * Makes the children of `parent` agree with the descriptions, reusing the elements that are there.
 * @param {Element} parent
 * @param {(Description | string)[]} children
 */
export function patch(parent, children) {
  children.forEach((child, k) => {
    const old = /** @type {Element | Text | undefined} */ (parent.childNodes[k]);
    if (old === undefined) parent.appendChild(create(parent, child));
    else if (typeof child === "string") {
      if (!(old instanceof Text)) parent.replaceChild(create(parent, child), old);
      else if (old.data !== child) old.data = child;
    } else if (old instanceof Element && old.localName === child.tag) update(old, child);
    else parent.replaceChild(create(parent, child), old);
  });
  while (parent.childNodes.length > children.length) parent.lastChild?.remove();
}

/**
 * The element with an id.
 * @param {string} id
 */
export function byId(id) {
  return /** @type {PageElement} */ (document.getElementById(id));
}

/**
 * The elements that a selector finds.
 * @param {string} selector
 * @param {ParentNode} within
 */
export function all(selector, within = document) {
  return /** @type {NodeListOf<PageElement>} */ (within.querySelectorAll(selector));
}

/**
 * The element that an event is about.
 * @param {Event} event
 */
export function targetOf(event) {
  return /** @type {PageElement} */ (event.target);
}

/**
 * The nearest element around an event that a selector finds, or null.
 * @param {Event} event
 * @param {string} selector
 */
export function closest(event, selector) {
  return /** @type {PageElement | null} */ (targetOf(event).closest(selector));
}

/**
 * One reader's change from a keyboard: the next index in a list of `count` for an arrow key, or null.
 * @param {string} key
 * @param {number} index
 * @param {number} count
 */
export function rove(key, index, count) {
  if (count === 0) return null;
  if (key === "ArrowRight" || key === "ArrowUp") return (index + 1) % count;
  if (key === "ArrowLeft" || key === "ArrowDown") return (index + count - 1) % count;
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  return null;
}
