import { Scene } from '@farol/engine';
import { afterEach, expect, test, vi } from 'vitest';
import { PanelLayout } from '../layout/PanelLayout';
import { PanelRegistry } from '../layout/PanelRegistry';
import { guardScripts } from '../scripts/guardScripts';
import { EditorDocument } from '../model/EditorDocument';
import { KeyBindings } from './KeyBindings';
import { createPreferences } from './preferences';

afterEach(() => vi.unstubAllGlobals());

const refuse = (): never => {
  throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
};

/** Fake storages: one that is full, one that is blocked, and one with malformed content. */
const storages: Record<string, object> = {
  full: { getItem: () => null, setItem: refuse, removeItem: refuse },
  blocked: { getItem: refuse, setItem: refuse, removeItem: refuse },
  odd: { getItem: () => '{"state":', setItem: () => {}, removeItem: () => {} },
};

test.each(Object.keys(storages))('what is chosen holds for the page where the storage of the browser is %s', (kind) => {
  const said = [vi.spyOn(console, 'warn'), vi.spyOn(console, 'error')];
  vi.stubGlobal('localStorage', storages[kind]);
  vi.stubGlobal('window', { localStorage: storages[kind] });
  const preferences = createPreferences('test');
  preferences.setState({ isMuted: true });
  expect(preferences.getState().isMuted).toBe(true);
  const layout = new PanelLayout(new PanelRegistry([]), 'test-layout');
  expect(() => layout.reset()).not.toThrow();
  const keys = new KeyBindings({ list: [] }, 'test-keys');
  expect(keys).toBeDefined();
  for (const each of said) {
    expect(each).not.toHaveBeenCalled();
    each.mockRestore();
  }
});

test('scripts are switched on and off where the tab has no storage', () => {
  vi.stubGlobal('location', { search: '' });
  vi.stubGlobal('addEventListener', () => {});
  vi.stubGlobal('sessionStorage', storages.blocked);
  const document = new EditorDocument();
  expect(() => guardScripts(document)).not.toThrow();
  expect(() => document.scripts.changed.emit()).not.toThrow();
});

test('scripts stay off in a frame of another page, also where the same ones have run before', () => {
  vi.stubGlobal('location', { search: '' });
  vi.stubGlobal('addEventListener', () => {});
  vi.stubGlobal('self', globalThis);
  vi.stubGlobal('top', {});
  const document = new EditorDocument();
  const { scripts } = document;
  guardScripts(document);
  expect(scripts.question).toBe('framed');
  scripts.isOn = true;
  expect(scripts.isOn).toBe(false);
  expect(scripts.question).toBe('framed');
  const scene = new Scene();
  scripts.open(scene, scene.registry, true);
  expect(scripts.isOn).toBe(false);
});
