import { builtinComponents, Camera, ComponentRegistry, GameObject, Scene } from '@farol/engine';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { actions, allActions } from '../../actions';
import { menuEntries, menuNames } from '../../actions/menuEntries';
import { labelOf } from '../../api/Action';
import type { EditorApi } from '../../api/EditorApi';
import { KeyBindings } from '../../api/KeyBindings';
import type { MenuEntry } from '../../api/MenuEntry';
import { createPreferences } from '../../api/preferences';
import { PanelLayout } from '../../layout/PanelLayout';
import { PanelRegistry } from '../../layout/PanelRegistry';
import { Clipboard } from '../../model/Clipboard';
import { EditorDocument } from '../../model/EditorDocument';
import { RecentFiles } from '../../model/RecentFiles';
import { Registry } from '../../model/Registry';
import { panels } from '..';
import { matchItems } from './matchItems';
import { LINES, paletteItems } from './paletteItems';

beforeEach(() => {
  vi.stubGlobal('localStorage', { getItem: () => null, setItem() {}, removeItem() {} });
  vi.stubGlobal('innerWidth', 1440);
  vi.stubGlobal('innerHeight', 900);
});
afterEach(() => void vi.unstubAllGlobals());

/** Stub for parts of the editor whose state affects no label: any property or call returns the stub again. */
const anything: object = new Proxy(() => anything, {
  get: (_, key) => (key === Symbol.toPrimitive ? () => 0 : key === Symbol.iterator ? undefined : anything),
});

/** An object that falls back to the stub for missing properties. */
const lenient = <T extends object>(known: T): T =>
  new Proxy(known, { get: (target, key) => (key in target ? target[key as keyof T] : anything) });

/** An editor with the parts that labels and available actions depend on. */
function makeEditor(): EditorApi {
  const registry = new Registry('an action', actions);
  const panelRegistry = new PanelRegistry(panels);
  const viewport = {
    farol: { techniques: { deferred: { label: 'Deferred' }, tiled: { label: 'Tiled' } } },
    space: 'local',
    technique: 'deferred',
    view: 'final',
    mode: 'translate',
    lookThrough: null,
  };
  const document = new EditorDocument(undefined, new ComponentRegistry(builtinComponents.types.values()));
  return lenient({
    document,
    commands: document.commands,
    viewport: lenient(viewport),
    clipboard: new Clipboard(),
    actions: registry,
    keys: new KeyBindings(registry, 'keys'),
    panels: panelRegistry,
    layout: new PanelLayout(panelRegistry, 'layout'),
    preferences: createPreferences('preferences'),
    recentFiles: new RecentFiles(),
    autosave: null,
  }) as unknown as EditorApi;
}

const linesOf = (entries: readonly MenuEntry[]): string[] =>
  entries.flatMap((entry) => (entry === 'separator' ? [] : 'entries' in entry ? linesOf(entry.entries) : entry.label));

it('has every action in the menus, those of plugins too', () => {
  const editor = makeEditor();
  editor.actions.add({ id: 'own.lamp', label: 'A lamp of my own', run() {} });
  const lines = new Set(menuNames.flatMap((menu) => linesOf(menuEntries(editor, menu))));
  const all = allActions(editor);
  expect(all.length).toBeGreaterThan(90);
  expect(all.filter((action) => !lines.has(labelOf(action, editor))).map(({ id }) => id)).toEqual([]);
  const edit = menuEntries(editor, 'edit');
  expect(edit.some((entry) => entry !== 'separator' && entry.label === 'Plugins')).toBe(true);
  // no separator is first, last or beside another one
  for (const menu of menuNames) {
    const marks = menuEntries(editor, menu).map((entry) => (entry === 'separator' ? '-' : 'x'));
    expect(marks.join('')).toMatch(/^x+(-x+)*$/);
  }
});

it('finds every action that can be done in the palette, by its name', () => {
  const editor = makeEditor();
  const scene = new Scene();
  const object = new GameObject('Chair');
  object.addComponent(Camera);
  scene.add(object);
  editor.document.open(scene);
  editor.document.selection.set([object.id]);
  const items = paletteItems(editor);
  const wanted = allActions(editor).filter((action) => action.enabled?.(editor) ?? true);
  const ids = new Set(items.map(({ id }) => id));
  expect(wanted.map(({ id }) => id).filter((id) => !ids.has(id))).toEqual(['help.palette']);
  const lost = items.filter(
    (item) =>
      !matchItems(items, item.label)
        .slice(0, LINES)
        .some(({ id }) => id === item.id),
  );
  expect(lost.map(({ id }) => id)).toEqual([]);
});

it('finds the guides of the site by their names', () => {
  const items = paletteItems(makeEditor());
  for (const name of ['Fog that lights light', 'Light in real units', 'Using the editor'])
    expect(matchItems(items, name)[0]).toMatchObject({ label: name, group: expect.stringMatching(/^Guides, /) });
});
