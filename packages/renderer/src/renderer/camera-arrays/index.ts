export { ArrayTraversal } from './ArrayTraversal';
export { renderArray } from './renderArray';
