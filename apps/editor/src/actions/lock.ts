import { t } from '@farol/editing';
import { setLocked } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const lock: Action = {
  id: 'edit.lock',
  label: ({ document: { selectedObjects } }) =>
    selectedObjects.length > 0 && selectedObjects.every(({ locked }) => locked) ? t('Unlock') : t('Lock'),
  keys: ['L'],
  icon: 'lock',
  menu: { menu: 'object', group: 'state' },
  run({ document, commands }) {
    const { selectedObjects } = document;
    commands.run(
      setLocked(
        selectedObjects,
        selectedObjects.some(({ locked }) => !locked),
      ),
    );
  },
  enabled: hasSelection,
};
