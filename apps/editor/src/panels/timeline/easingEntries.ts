import { t } from '@farol/editing';
import type { MenuEntry } from '../../api/MenuEntry';
import { namedCurves, STRAIGHT } from '../../model/timeline/easingCurve';
import { selectedKeys } from '../../model/timeline/editKeys';
import type { Timeline } from '../../model/timeline/Timeline';
import { easeSelected } from '../../model/timeline/timelineEdits';

/** Menu of easings from the selected keys to the next ones. */
export function easingEntries(timeline: Timeline): MenuEntry[] {
  const keys = selectedKeys(timeline.data, timeline.selection.keys).map(({ key }) => key);
  const curve = (key: (typeof keys)[0]): string => (key.control ?? STRAIGHT).join();
  const isAll = (name: 'step' | 'linear'): boolean => keys.every(({ easing = 'linear' }) => easing === name);
  const isCurve = (control: readonly number[]): boolean =>
    keys.every((key) => key.easing === 'bezier' && curve(key) === control.join());
  const named = Object.values(namedCurves).map((control) => control.join());
  return [
    { label: t('Step'), checked: isAll('step'), run: () => easeSelected(timeline, 'step') },
    { label: t('Linear'), checked: isAll('linear'), run: () => easeSelected(timeline, 'linear') },
    'separator',
    ...(
      [
        [t('Ease in'), namedCurves.easeIn],
        [t('Ease out'), namedCurves.easeOut],
        [t('Ease in and out'), namedCurves.easeInOut],
      ] as const
    ).map(([label, control]) => ({
      label,
      checked: isCurve(control),
      run: () => easeSelected(timeline, 'bezier', control),
    })),
    'separator',
    {
      label: t('Bézier'),
      help: t('Handles in the curve view.'),
      checked: keys.every((key) => key.easing === 'bezier' && !named.includes(curve(key))),
      run: () => easeSelected(timeline, 'bezier', STRAIGHT),
    },
  ];
}
