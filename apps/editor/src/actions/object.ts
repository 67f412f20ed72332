import { t } from '@farol/editing';
import { instanceRootOf } from '@farol/engine/prefabs';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { PhysicsKind } from '../model/addPhysics';
import { setActive, setLocked } from '../model/edits';
import { hasSelection } from './hasSelection';

export const rename: Action = {
  id: 'edit.rename',
  label: 'Rename',
  keys: ['F2'],
  run: ({ renameRequested }) => renameRequested.emit(),
  enabled: ({ document }) => document.selection.ids.length === 1,
};

export const hide: Action = {
  id: 'edit.hide',
  label: ({ document: { selectedObjects } }) =>
    selectedObjects.length > 0 && selectedObjects.every(({ active }) => !active) ? t('Show') : t('Hide'),
  keys: ['H'],
  icon: 'eye',
  run({ document, commands }) {
    const { selectedObjects } = document;
    commands.run(setActive(selectedObjects, !selectedObjects.some(({ active }) => active)));
  },
  enabled: hasSelection,
};

export const lock: Action = {
  id: 'edit.lock',
  label: ({ document: { selectedObjects } }) =>
    selectedObjects.length > 0 && selectedObjects.every(({ locked }) => locked) ? t('Unlock') : t('Lock'),
  keys: ['L'],
  icon: 'lock',
  run({ document, commands }) {
    const { selectedObjects } = document;
    const isLocked = selectedObjects.every(({ locked }) => locked);
    commands.run(setLocked(selectedObjects, !isLocked));
  },
  enabled: hasSelection,
};

const areStatic = ({ document }: EditorApi): boolean => document.selectedObjects.every(({ isStatic }) => isStatic);

/** Marks the selected objects as static, or as moving. */
export const toggleStatic: Action = {
  id: 'edit.static',
  label: 'Static',
  icon: 'lamp',
  async run(editor) {
    const { selectedObjects } = editor.document;
    const isStatic = !areStatic(editor);
    const { changeStatic } = await import('./changeStatic');
    void changeStatic(editor, selectedObjects, isStatic); // not awaited: a dialog may stay open after the action has ended
  },
  enabled: hasSelection,
  checked: (editor) => editor.document.selectedObjects.length > 0 && areStatic(editor),
};

export const bakeLight: Action = {
  id: 'object.bake-light',
  label: 'Bake light…',
  icon: 'lamp',
  run: ({ layout }) => layout.open('bake'),
};

export const group: Action = {
  id: 'edit.group',
  label: 'Group',
  keys: ['Ctrl+G'],
  icon: 'folder',
  async run({ document, commands }) {
    const { groupObjects } = await import('../model/groupObjects');
    if (document.selectedObjects.length > 0) commands.run(groupObjects(document.scene, document.selectedObjects));
  },
  enabled: hasSelection,
};

export const ungroup: Action = {
  id: 'edit.ungroup',
  label: 'Ungroup',
  keys: ['Ctrl+Shift+G'],
  async run({ document, commands }) {
    const { ungroupObjects } = await import('../model/groupObjects');
    if (document.selectedObjects.length > 0) commands.run(ungroupObjects(document.scene, document.selectedObjects));
  },
  enabled: ({ document }) => document.selectedObjects.some(({ children }) => children.length > 0),
};

/** Opens the tool that copies along a line, on a ring, on a grid or over a surface. */
export const duplicateMany: Action = {
  id: 'edit.duplicate-many',
  label: 'Duplicate along…',
  keys: ['Shift+D'],
  icon: 'duplicate',
  async run({ document, viewport, tools }) {
    const { DuplicateTool } = await import('../viewport/placing/DuplicateTool');
    if (document.selection.ids.length === 0) return;
    // the open tool is ended before another one is made, since it restores the scene when it ends
    tools.end();
    const tool: { current: InstanceType<typeof DuplicateTool> | null } = { current: null };
    tool.current = new DuplicateTool(document, viewport.rayCamera, () => tools.end(tool.current));
    tools.open(tool.current);
  },
  enabled: hasSelection,
};

export const makePrefab: Action = {
  id: 'prefab.make',
  label: 'Make prefab',
  icon: 'prefab',
  async run({ document, commands, notices }) {
    const [object] = document.selectedObjects;
    const { createPrefab } = await import('../model/prefabEdits');
    if (object.scene !== document.scene) return;
    commands.run(createPrefab(document.scene, object, document.selection.ids));
    notices.show('info', t('{name} is a prefab: place it from Assets', { name: object.name }));
  },
  enabled: ({ document }) => {
    const { selectedObjects } = document;
    if (selectedObjects.length !== 1) return false;
    const root = instanceRootOf(selectedObjects[0]);
    return root === null || root === selectedObjects[0];
  },
};

/** Turns the selected prefab instance into plain objects. */
export const unpackPrefab: Action = {
  id: 'prefab.unpack',
  label: 'Unpack prefab',
  icon: 'object',
  async run({ document, commands }) {
    const root = instanceRootOf(document.selectedObjects[0]);
    const { unpackInstance } = await import('../model/prefabEdits');
    if (root && root.scene === document.scene)
      commands.run(unpackInstance(document.scene, root, document.selection.ids));
  },
  enabled: ({ document }) =>
    document.selectedObjects.length === 1 && instanceRootOf(document.selectedObjects[0]) !== null,
};

const makes = (kind: PhysicsKind, label: string, icon: Action['icon']): Action => ({
  id: `physics.${kind}`,
  label,
  icon,
  enabled: hasSelection,
  async run({ document, commands }) {
    const { addPhysics } = await import('../model/addPhysics');
    commands.run(addPhysics(document.scene, document.selectedObjects, kind));
  },
});

/** Actions that make the selected objects physics bodies, with colliders fitted to their meshes. */
export const physicsActions: readonly Action[] = [
  makes('dynamic', 'Add dynamic body and collider', 'body'),
  makes('kinematic', 'Add kinematic body and collider', 'body'),
  makes('fixed', 'Add fixed collider', 'collider'),
  makes('character', 'Add character controller', 'character'),
];
