/** The order in which the Tab key visits what lies over the picture: as it is read, row by row and from left to right. */

// px. Handles whose middles differ by less in height are in one row.
const kRowPx = 24;

/**
 * @param {{node: HTMLElement, x: number, y: number}[]} items with their middles in the picture
 * @returns {HTMLElement[]}
 */
export function readingOrder(items) {
  const rest = [...items].sort((a, b) => a.y - b.y);
  const order = [];
  while (rest.length > 0) {
    const inRow = rest.findIndex(({ y }) => y - rest[0].y >= kRowPx);
    const row = rest.splice(0, inRow < 0 ? rest.length : inRow);
    order.push(...row.sort((a, b) => a.x - b.x).map(({ node }) => node));
  }
  return order;
}

/**
 * Brings children of a container into this order, which is the Tab key's. The one with the focus stays where it is, for a node
 * that is moved loses it.
 * @param {HTMLElement} container
 * @param {HTMLElement[]} nodes
 */
export function arrange(container, nodes) {
  const wanted = new Set(nodes);
  const present = [...container.children].filter((node) => wanted.has(node));
  if (present.every((node, i) => node === nodes[i])) return;
  const focused = nodes.indexOf(container.getRootNode().activeElement);
  nodes.forEach((node, i) => {
    if (i < focused) container.insertBefore(node, nodes[focused]);
    else if (i > focused) container.append(node);
  });
}
