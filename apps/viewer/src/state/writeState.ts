import type { FieldValue } from '@farol/engine/fields';
import type { KnownNames, ViewerState } from './ViewerState';

/**
 * Makes the query of a URL that restores a state: scene, technique, view, and all values that differ from the defaults.
 * `readState(writeState(state))` is `state` without parameters that the scene does not have.
 *
 * @param isScene - false for a dropped model, which a query cannot contain: it then names no scene. Default true
 * @returns the query with its '?'
 */
export function writeState(state: ViewerState, { scenes, effects, defaults }: KnownNames, isScene = true): string {
  const entries: [string, FieldValue][] = [
    ['technique', state.technique],
    ['view', state.view],
  ];
  if (isScene) entries.unshift(['scene', state.scene]);
  const fields = isScene ? (scenes[state.scene]?.parameters ?? {}) : {};
  for (const [name, field] of Object.entries(fields)) {
    const value = state.parameters[name];
    if (value !== undefined && String(value) !== String(field.default)) entries.push([name, value]);
  }
  for (const name of [
    'quality',
    'aa',
    'particles',
    'rectangles',
    'time',
    'width',
    'height',
    'dpr',
    'budget',
  ] as const) {
    if (state[name] !== defaults[name]) entries.push([name, state[name]]);
  }
  for (const [name, field] of Object.entries(effects)) {
    const value = state.effects[name] ?? field.default;
    if (value !== field.default) entries.push([name, value]);
  }
  if (state.decals !== defaults.decals) entries.push(['decals', state.decals]);
  if (state.gui !== defaults.gui) entries.push(['gui', state.gui]);
  return `?${entries.map(([name, value]) => `${name}=${encodeURIComponent(text(value))}`).join('&')}`.replaceAll(
    '%2C',
    ',',
  );
}

function text(value: FieldValue): string {
  return typeof value === 'boolean' ? (value ? '1' : '0') : String(value);
}

/** Replaces the query of the page's address without a new history entry. @param search - query with its ? */
export function writeAddress(search: string): void {
  // the whole address, since a path such as //x/ alone would mean another host
  const address = new URL(location.href);
  address.search = search;
  try {
    history.replaceState(history.state, '', address);
  } catch {
    // Safari refuses more than 100 changes in 30 s; the next change writes the whole state
  }
}
