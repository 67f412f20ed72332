import { expect, it } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { actions } from '.';

it('gives each action an id and keys of its own', () => {
  const ids = actions.map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
  const keys = actions.flatMap((action) => action.keys ?? []);
  expect(new Set(keys).size).toBe(keys.length);
});

it('has every key of EDITOR.md that this editor can do', () => {
  const keys = new Set(actions.flatMap((action) => action.keys ?? []));
  const wanted =
    'Q W E R X F Ctrl+Z Ctrl+Y Ctrl+Shift+Z Ctrl+D Delete F2 H Ctrl+S Ctrl+O Ctrl+P Ctrl+Shift+P Ctrl+Alt+P Ctrl+K Space ?';
  for (const key of wanted.split(' ')) expect(keys).toContain(key);
});

it('calls what nothing is selected for by what it does at first', () => {
  const nothing = { document: { selectedObjects: [] } } as unknown as EditorApi;
  const labelOf = (id: string): string => {
    const { label } = actions.find((action) => action.id === id)!;
    return typeof label === 'function' ? label(nothing) : label;
  };
  expect(labelOf('edit.hide')).toBe('Hide');
  expect(labelOf('edit.lock')).toBe('Lock');
});
