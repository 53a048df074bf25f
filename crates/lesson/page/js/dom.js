// @ts-check
// Descriptions of elements, and a patcher that makes the document agree with them. Elements that stay keep their
// identity, and with it the focus and the pointer: a picture can be redrawn under the reader's hand.

/** @type {Record<string, string>} */
const NAMESPACES = {
  svg: "http://www.w3.org/2000/svg",
  math: "http://www.w3.org/1998/Math/MathML",
};

// What the reader has typed, ticked or chosen is a property; attributes are only its first value. The value of a list is one of its
// options: these come first.
const PROPERTIES = ["checked", "selected", "value", "disabled", "hidden"];

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
    if (PROPERTIES.includes(name)) continue;
    if (before[name] === value) continue;
    if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : `${value}`);
  }
  described.set(node, description);
  patch(node, children);
  const control = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (node));
  for (const name of PROPERTIES) if (name in attributes && control[name] !== attributes[name]) control[name] = attributes[name];
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
  while (parent.childNodes.length > children.length) {
    const last = /** @type {ChildNode} */ (parent.lastChild);
    const focused = /** @type {HTMLElement} */ (document.activeElement);
    const hadFocus = last.contains(focused);
    // Who hears that the focus is lost draws as well, and may remove it: not in the middle of a removal, which browsers refuse.
    if (hadFocus) focused.blur();
    if (last.parentNode === parent) last.remove();
    if (hadFocus) focusLast(parent);
  }
}

/**
 * Keeps the focus near what is gone, once everything is drawn: where there is nothing, keys would begin anew at the top of the page.
 * @param {Element} parent
 */
function focusLast(parent) {
  const last = parent.lastElementChild;
  const found = last?.matches("[tabindex]") ? last : [...(last?.querySelectorAll("button,input,[tabindex]") ?? [])].at(-1);
  queueMicrotask(() => /** @type {HTMLElement | undefined} */ (found)?.focus());
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
