import { labelOfField, t } from '@farol/editing';
import { type ClipData, type ClipTrack, type Component, type GameObject, trackTarget } from '@farol/engine';
import { type Field, isTriple } from '@farol/engine/fields';
import { componentName } from '../../model/componentName';
import { isAnimatable, trackId } from '../../model/timeline/clipTracks';

/** Row of the tracks of one component. */
export interface GroupRow {
  readonly kind: 'group';
  readonly id: string;
  /** Label of the row, such as 'Cube: Transform'. */
  readonly label: string;
  readonly isOpen: boolean;
  readonly tracks: readonly ClipTrack[];
  /** Whether the target of one of the tracks is missing. */
  readonly isLost: boolean;
}

export interface TrackRow {
  readonly kind: 'track';
  /** `trackId` of the track. */
  readonly id: string;
  readonly label: string;
  readonly track: ClipTrack;
  /** The component that the track animates; null when it does not exist, or no object plays the clip. */
  readonly target: Component | null;
  readonly field: Field | null;
  /** Why the track has no effect; null when it has, or no object plays the clip. */
  readonly problem: string | null;
  /** Whether rows for the track's coordinates are shown; null for a track without coordinates. */
  readonly isOpen: boolean | null;
}

/** Row of one coordinate of a vector, in the curve view. */
export interface ChannelRow {
  readonly kind: 'channel';
  readonly id: string;
  readonly label: string;
  readonly channel: 0 | 1 | 2;
  readonly row: TrackRow;
}

export interface EventsRow {
  readonly kind: 'events';
  readonly id: 'events';
  readonly label: string;
}

export type TimelineRow = EventsRow | GroupRow | TrackRow | ChannelRow;

/** Rows that the user has folded (groups) or unfolded (vectors). */
export interface RowFolds {
  readonly folded: ReadonlySet<string>;
  readonly unfolded: ReadonlySet<string>;
  /** Whether the view shows rows for coordinates. */
  readonly hasChannels: boolean;
}

const CHANNELS = [0, 1, 2] as const;

/** Letters of a vector's or colour's coordinates: 'xyz' or 'rgb'. */
export const channelNames = (field: Field | null): string => (field?.kind === 'colour' ? 'rgb' : 'xyz');

const objectLabel = (root: GameObject | null, path: string): string =>
  path === '' ? (root?.name ?? t('Object')) : path.replaceAll('/', ' / ');

function trackRow(root: GameObject | null, track: ClipTrack, folds: RowFolds): TrackRow {
  const id = trackId(track);
  const { component: target, problem } = root ? trackTarget(root, track) : { component: null, problem: null };
  const found = target?.fields[track.field] ?? null;
  const field = found && isAnimatable(found) ? found : null;
  const hasChannels = folds.hasChannels && isTriple(track.keys[0]?.value);
  return {
    kind: 'track',
    id,
    label: labelOfField(track.field, found ?? {}),
    track,
    target,
    field,
    problem: problem ?? (target && !field ? t('This field cannot be animated.') : null),
    isOpen: hasChannels ? folds.unfolded.has(id) : null,
  };
}

/** The rows of a clip: its events, then its tracks by object and component. @param root - the object that the clip animates */
export function timelineRows(root: GameObject | null, data: ClipData, folds: RowFolds): TimelineRow[] {
  const groups = new Map<string, ClipTrack[]>();
  for (const track of data.tracks) {
    const id = `${track.path}\n${track.component}`;
    const tracks = groups.get(id);
    if (tracks) tracks.push(track);
    else groups.set(id, [track]);
  }
  const rows: TimelineRow[] = [{ kind: 'events', id: 'events', label: t('Events') }];
  for (const [id, tracks] of groups) {
    const [{ path, component }] = tracks;
    const isOpen = !folds.folded.has(id);
    const label = t('{object}: {component}', { object: objectLabel(root, path), component: componentName(component) });
    const isLost = root !== null && tracks.some((track) => trackTarget(root, track).problem !== null);
    rows.push({ kind: 'group', id, label, isOpen, tracks, isLost });
    if (!isOpen) continue;
    for (const track of tracks) {
      const row = trackRow(root, track, folds);
      rows.push(row);
      if (!row.isOpen) continue;
      const names = channelNames(row.field);
      for (const channel of CHANNELS)
        rows.push({ kind: 'channel', id: `${row.id}\n${channel}`, label: names[channel], channel, row });
    }
  }
  return rows;
}
