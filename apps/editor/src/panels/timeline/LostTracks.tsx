import { t } from '@farol/editing';
import { type GameObject, pathBelow } from '@farol/engine';
import type { ReactNode } from 'react';
import type { MenuEntry } from '../../api/MenuEntry';
import { retargetTracks } from '../../model/timeline/timelineEdits';
import { MenuButton } from '../../ui/MenuButton';
import type { GroupRow } from './timelineRows';
import type { TimelineView } from './TimelineView';

/** Assigns tracks whose object was renamed or removed to another object that has the component. */
export function LostTracks({ view, row }: { view: TimelineView; row: GroupRow }): ReactNode {
  const { timeline } = view;
  const entries = (): MenuEntry[] => {
    const { root } = timeline;
    const objects: GameObject[] = [];
    root?.traverse((object) => {
      if (object.getComponent(row.tracks[0].component)) objects.push(object);
    });
    const lines = objects.flatMap((object): MenuEntry[] => {
      const path = pathBelow(root!, object);
      if (path === null) return [];
      const label = path === '' ? object.name : path.replaceAll('/', ' / ');
      return [{ label, run: () => retargetTracks(timeline, row.tracks, path, object.name) }];
    });
    return lines.length > 0 ? lines : [{ label: t('No object has this component.'), disabled: true, run() {} }];
  };
  return (
    <MenuButton
      label={t('Choose another object')}
      icon="warning"
      iconOnly
      className="track-key track-lost"
      entries={entries}
    />
  );
}
