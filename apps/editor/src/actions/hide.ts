import { t } from '@farol/editing';
import { setActive } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const hide: Action = {
  id: 'edit.hide',
  label: ({ document: { selectedObjects } }) =>
    selectedObjects.length > 0 && selectedObjects.every(({ active }) => !active) ? t('Show') : t('Hide'),
  keys: ['H'],
  icon: 'eye',
  menu: { menu: 'object', group: 'state' },
  run({ document, commands }) {
    const { selectedObjects } = document;
    commands.run(setActive(selectedObjects, !selectedObjects.some(({ active }) => active)));
  },
  enabled: hasSelection,
};
