import { t } from '@farol/editing';
import { instanceRootOf } from '@farol/engine/prefabs';
import type { Action } from '../api/Action';

export const makePrefab: Action = {
  id: 'prefab.make',
  label: 'Make prefab',
  icon: 'prefab',
  menu: { menu: 'object', group: 'prefab' },
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

/** Turns the selected instance into plain objects. */
export const unpackPrefab: Action = {
  id: 'prefab.unpack',
  label: 'Unpack prefab',
  icon: 'object',
  menu: { menu: 'object', group: 'prefab' },
  async run({ document, commands }) {
    const root = instanceRootOf(document.selectedObjects[0]);
    const { unpackInstance } = await import('../model/prefabEdits');
    if (root && root.scene === document.scene)
      commands.run(unpackInstance(document.scene, root, document.selection.ids));
  },
  enabled: ({ document }) =>
    document.selectedObjects.length === 1 && instanceRootOf(document.selectedObjects[0]) !== null,
};
