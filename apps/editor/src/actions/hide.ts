import { t } from '@farol/editing';
import { setActive } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const hide: Action = {
  id: 'edit.hide',
  label: ({ document }) => (document.selectedObjects.some(({ active }) => active) ? t('Hide') : t('Show')),
  keys: ['H'],
  icon: 'eye',
  menu: { menu: 'object', group: 'state' },
  run({ document, commands }) {
    const { selectedObjects } = document;
    commands.run(setActive(selectedObjects, !selectedObjects.some(({ active }) => active)));
  },
  enabled: hasSelection,
};
