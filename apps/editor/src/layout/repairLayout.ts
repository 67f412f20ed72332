import { removePanel } from './editLayout';
import { groupsOf, type LayoutNode } from './LayoutNode';

const isObject = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null;

/** Whether a stored value has the structure of a layout. */
function isLayout(value: unknown): value is LayoutNode {
  if (!isObject(value)) return false;
  if (value.kind === 'group') {
    const { id, panels, active } = value;
    return typeof id === 'string' && Array.isArray(panels) && panels.length > 0 && panels.includes(active);
  }
  if (value.kind !== 'split' || (value.direction !== 'row' && value.direction !== 'column')) return false;
  const { children, sizes } = value;
  if (!Array.isArray(children) || !Array.isArray(sizes)) return false;
  if (children.length < 2 || sizes.length !== children.length) return false;
  return sizes.every((size) => Number.isFinite(size) && size > 0) && children.every(isLayout);
}

/**
 * Removes unknown panels from a stored layout.
 * @returns null when the value is malformed, or nothing is left
 */
export function repairLayout(stored: unknown, known: (panel: string) => boolean): LayoutNode | null {
  if (!isLayout(stored)) return null;
  const groups = groupsOf(stored);
  const ids = groups.flatMap(({ panels }) => panels);
  if (new Set(ids).size !== ids.length || new Set(groups.map(({ id }) => id)).size !== groups.length) return null;
  let layout: LayoutNode | null = stored;
  for (const id of ids) if (layout && !known(id)) layout = removePanel(layout, id);
  return layout;
}
