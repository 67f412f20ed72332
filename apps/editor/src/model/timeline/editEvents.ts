/** Edits of the events of a clip, which are sorted by time and identified by index; several may share a time. */
import type { ClipData, ClipEvent } from '@farol/engine';
import { roundTime } from './clipTracks';

const inOrder = (a: ClipEvent, b: ClipEvent): number => a.time - b.time;

/** A clip after an edit of events, and the indices of the edited events. */
export interface EventEdit {
  readonly data: ClipData;
  readonly places: readonly number[];
}

function sorted(data: ClipData, events: readonly ClipEvent[], edited: readonly ClipEvent[]): EventEdit {
  const list = events.toSorted(inOrder);
  return { data: { ...data, events: list }, places: edited.map((event) => list.indexOf(event)) };
}

export const addEvent = (data: ClipData, event: ClipEvent): EventEdit => sorted(data, [...data.events, event], [event]);

/** Changes method, time or value of an event; `value: undefined` removes the value. */
export function changeEvent(data: ClipData, place: number, change: Partial<ClipEvent>): EventEdit {
  const { value, ...rest } = { ...data.events[place], ...change };
  const event: ClipEvent = value === undefined ? rest : { ...rest, value };
  return sorted(data, data.events.with(place, event), [event]);
}

/** Moves events, none of them before time 0. @param by - seconds */
export function moveEvents(data: ClipData, places: readonly number[], by: number): EventEdit {
  const first = Math.min(...places.map((place) => data.events[place].time));
  const limited = Math.max(by, -first);
  const moved = new Map(
    places.map((place) => {
      const event = data.events[place];
      return [place, { ...event, time: roundTime(Math.max(event.time + limited, 0)) }];
    }),
  );
  const events = data.events.map((event, i) => moved.get(i) ?? event);
  return sorted(data, events, [...moved.values()]);
}

/** Removes events, given by their indices. */
export const removeEvents = (data: ClipData, places: readonly number[]): ClipData => ({
  ...data,
  events: data.events.filter((_, i) => !places.includes(i)),
});
