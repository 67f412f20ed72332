import { shortText } from '@farol/editing';
import { describeValue, type FieldValue, isFieldValue, isTriple } from '@farol/editing/fields';
import { copyValue } from '../../fields/FieldOwner';
import type { ClipData, ClipEvent, ClipKey, ClipTrack, Easing } from './ClipData';

/** Error for a text that is no valid clip: names clip, track and key. */
export class ClipError extends Error {
  constructor(clip: string, problem: string) {
    super(`The clip '${shortText(clip, 80)}': ${problem}`);
    this.name = 'ClipError';
  }
}

export const emptyClip: ClipData = Object.freeze({ tracks: Object.freeze([]), events: Object.freeze([]) });

const easings: readonly unknown[] = ['linear', 'step', 'bezier'] satisfies Easing[];

/** Greatest number of tracks in a clip; a file with more is refused. */
const MOST_TRACKS = 20_000;
const MOST_KEYS = 2_000_000;

/** Kind of a key's value; all keys of a track have values of one kind. */
export const kindOfValue = (value: FieldValue): 'number' | 'vector' | 'keys' | 'flag' | 'text' => {
  if (typeof value === 'number') return 'number';
  if (isTriple(value)) return 'vector';
  if (Array.isArray(value)) return 'keys';
  return typeof value === 'boolean' ? 'flag' : 'text';
};

/** Name of a track's target for messages: "'Arm/Hand', Transform.position". */
export const describeTrack = ({ path, component, field }: Pick<ClipTrack, 'path' | 'component' | 'field'>): string =>
  `${path === '' ? '' : `'${shortText(path, 60)}', `}${shortText(component)}.${shortText(field)}`;

/**
 * Parses the text of a ClipAsset; '' is a clip without tracks. The result is validated, its keys sorted by time.
 * @param name - of the clip, for messages
 * @throws ClipError naming clip, track and key
 */
export function parseClip(text: string, name = ''): ClipData {
  if (text === '') return emptyClip;
  const fail = (problem: string): never => {
    throw new ClipError(name, problem);
  };
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch {
    fail('its data are not JSON: export it again.');
  }
  const { tracks = [], events = [] } = recordOf(data) ?? fail('its data must be an object with tracks and events.');
  if (!Array.isArray(tracks)) fail('tracks must be a list.');
  if (!Array.isArray(events)) fail('events must be a list.');
  if ((tracks as unknown[]).length > MOST_TRACKS) fail(`it has more than ${MOST_TRACKS} tracks: split the clip.`);
  const seen = new Set<string>();
  let keys = 0;
  const read = (tracks as unknown[]).map((each, i) => {
    const track = readTrack(each, `track ${i + 1}`, fail);
    const id = JSON.stringify([track.path, track.component, track.field]);
    if (seen.has(id)) fail(`track ${i + 1} (${describeTrack(track)}) is there twice: leave one of them.`);
    seen.add(id);
    if ((keys += track.keys.length) > MOST_KEYS) fail(`it has more than ${MOST_KEYS} keys: split the clip.`);
    return track;
  });
  if ((events as unknown[]).length > MOST_KEYS) fail(`it has more than ${MOST_KEYS} events: split the clip.`);
  const readEvents = (events as unknown[]).map((each, i) => readEvent(each, `event ${i + 1}`, fail));
  return { tracks: read, events: readEvents.toSorted((a, b) => a.time - b.time) };
}

type Fail = (problem: string) => never;

const recordOf = (value: unknown): Record<string, unknown> | null =>
  typeof value === 'object' && value !== null && !Array.isArray(value) ? (value as Record<string, unknown>) : null;

const isTime = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value) && value >= 0;

function readTrack(given: unknown, place: string, fail: Fail): ClipTrack {
  const { path, component, field, keys } = recordOf(given) ?? fail(`${place} must be an object.`);
  if (typeof path !== 'string') return fail(`${place}: path must be text, not ${describeValue(path)}.`);
  if (typeof component !== 'string' || component === '')
    return fail(`${place}: component must be the name of a type, not ${describeValue(component)}.`);
  if (typeof field !== 'string' || field === '')
    return fail(`${place}: field must be the name of a field, not ${describeValue(field)}.`);
  const named = `${place} (${describeTrack({ path, component, field })})`;
  if (!Array.isArray(keys)) return fail(`${named}: keys must be a list.`);
  const read = keys.map((each, i) => readKey(each, `${named}, key ${i + 1}`, fail));
  for (let i = 1; i < read.length; i++) {
    if (read[i].time <= read[i - 1].time)
      fail(`${named}, key ${i + 1}: its time (${read[i].time} s) must come after the key before it.`);
    if (kindOfValue(read[i].value) !== kindOfValue(read[0].value))
      fail(`${named}, key ${i + 1}: ${describeValue(read[i].value)} is of another kind than the values before it.`);
  }
  return { path, component, field, keys: read };
}

function readKey(given: unknown, place: string, fail: Fail): ClipKey {
  const { time, value, easing, control } = recordOf(given) ?? fail(`${place} must be an object.`);
  if (!isTime(time)) return fail(`${place}: time must be 0 s or more, not ${describeValue(time)}.`);
  if (!isFieldValue(value)) return fail(`${place}: value must be what a field can be, not ${describeValue(value)}.`);
  if (easing !== undefined && !easings.includes(easing))
    return fail(`${place}: easing must be linear, step or bezier, not ${describeValue(easing)}.`);
  const key: { -readonly [K in keyof ClipKey]: ClipKey[K] } = { time, value: copyOf(value) };
  if (easing !== undefined && easing !== 'linear') key.easing = easing as Easing;
  if (control !== undefined && easing === 'bezier') key.control = readControl(control, place, fail);
  return key;
}

/** Copy of a value, so that no other clip shares its arrays; -0 becomes 0, as in fields. */
const copyOf = (value: FieldValue): FieldValue => {
  if (typeof value === 'number') return value + 0;
  return isTriple(value) ? [value[0] + 0, value[1] + 0, value[2] + 0] : copyValue(value);
};

function readControl(given: unknown, place: string, fail: Fail): NonNullable<ClipKey['control']> {
  const isNumber = (value: unknown): boolean => typeof value === 'number' && Number.isFinite(value);
  if (!Array.isArray(given) || given.length !== 4 || !given.every(isNumber))
    return fail(`${place}: control must be [x1, y1, x2, y2], not ${describeValue(given)}.`);
  const [x1, y1, x2, y2] = given as number[];
  if (Math.min(x1, x2) < 0 || Math.max(x1, x2) > 1) fail(`${place}: x1 and x2 of control must be from 0 to 1.`);
  return [x1, y1, x2, y2];
}

function readEvent(given: unknown, place: string, fail: Fail): ClipEvent {
  const { time, method, value } = recordOf(given) ?? fail(`${place} must be an object.`);
  if (!isTime(time)) return fail(`${place}: time must be 0 s or more, not ${describeValue(time)}.`);
  if (typeof method !== 'string' || method === '')
    return fail(`${place}: method must be the name of a method, not ${describeValue(method)}.`);
  if (value === undefined) return { time, method };
  if (!isFieldValue(value)) return fail(`${place}: value must be what a field can be, not ${describeValue(value)}.`);
  return { time, method, value: copyOf(value) };
}
