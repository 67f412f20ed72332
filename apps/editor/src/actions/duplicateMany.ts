import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

/** Opens the tool that copies along a line, on a ring, on a grid or over a surface. */
export const duplicateMany: Action = {
  id: 'edit.duplicate-many',
  label: 'Duplicate along…',
  keys: ['Shift+D'],
  icon: 'duplicate',
  menu: { menu: 'object', group: 'duplicate' },
  async run({ document, viewport, tools }) {
    const { DuplicateTool } = await import('../viewport/placing/DuplicateTool');
    if (document.selection.ids.length === 0) return;
    // first, since an open tool restores the scene when it ends
    tools.end();
    const tool: { current: InstanceType<typeof DuplicateTool> | null } = { current: null };
    tool.current = new DuplicateTool(document, viewport.rayCamera, () => tools.end(tool.current));
    tools.open(tool.current);
  },
  enabled: hasSelection,
};
