import type { ClipTrack } from '@farol/engine';
import type { TimelineView } from './TimelineView';

/** The tracks of the chosen rows, or all when none is chosen. */
export function tracksForKeys({ rows, chosen, timeline }: TimelineView): ClipTrack[] {
  const tracks = new Set<ClipTrack>();
  for (const row of rows) {
    if (!chosen.has(row.id)) continue;
    if (row.kind === 'track') tracks.add(row.track);
    else if (row.kind === 'channel') tracks.add(row.row.track);
    else if (row.kind === 'group') row.tracks.forEach((track) => tracks.add(track));
  }
  return tracks.size > 0 ? [...tracks] : [...timeline.data.tracks];
}
