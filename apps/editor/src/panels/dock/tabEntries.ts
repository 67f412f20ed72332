import { t } from '@farol/editing';
import type { DropSide } from '../../layout/LayoutNode';
import type { PlacedGroup } from '../../layout/placeLayout';
import type { Panel } from '../../layout/PanelRegistry';
import type { EditorApi } from '../../api/EditorApi';
import type { MenuEntry } from '../../api/MenuEntry';
import { dropTowards } from './dropTowards';

const sides = (): [Exclude<DropSide, 'centre'>, string, string][] => [
  ['left', t('Move left'), 'Alt+Shift+←'],
  ['right', t('Move right'), 'Alt+Shift+→'],
  ['top', t('Move up'), 'Alt+Shift+↑'],
  ['bottom', t('Move down'), 'Alt+Shift+↓'],
];

const halves = (): [Exclude<DropSide, 'centre'>, string][] => [
  ['left', t('Left half')],
  ['right', t('Right half')],
  ['top', t('Upper half')],
  ['bottom', t('Lower half')],
];

/** Context menu of a panel's tab. */
export function tabEntries(
  { panels, layout }: EditorApi,
  panel: Panel,
  groups: readonly PlacedGroup[],
  isMaximised: boolean,
): MenuEntry[] {
  const { id } = panel;
  const from = groups.find(({ group }) => group.panels.includes(id));
  const moves = sides().map(([side, label, keys]): MenuEntry => {
    const drop = dropTowards(groups, id, side);
    return { label, keys, disabled: !drop || isMaximised, run: () => drop && layout.move(id, drop) };
  });
  const into = groups
    .filter(({ group }) => group !== from?.group)
    .map(({ group, rectangle: { width, height } }): MenuEntry => ({
      label: group.panels.map((each) => t(panels.get(each)?.title ?? each)).join(', '),
      entries: [
        { label: t('As a tab'), run: () => layout.move(id, { group: group.id, side: 'centre' }) },
        ...halves().map(([side, label]): MenuEntry => ({
          label,
          run: () =>
            layout.move(id, {
              group: group.id,
              side,
              extent: side === 'left' || side === 'right' ? width : height,
            }),
        })),
      ],
    }));
  return [
    ...moves,
    ...(into.length > 0 && !isMaximised ? [{ label: t('Move to the place of'), entries: into }] : []),
    'separator',
    {
      label: isMaximised ? t('Give the window back') : t('Maximise'),
      icon: 'maximise',
      run: () => layout.maximise(isMaximised ? null : id),
    },
    { label: t('Close'), icon: 'close', keys: 'Delete', run: () => layout.close(id) },
    'separator',
    { label: t('Reset the panels'), icon: 'panels', run: () => layout.reset() },
  ];
}
