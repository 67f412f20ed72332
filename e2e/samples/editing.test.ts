/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import {
  CommandStack,
  englishLabelOfField,
  isComposing,
  latinKey,
  namesOf,
  placePivot,
  replaceOwner,
  SetFields,
  setTexts,
  sharedIcons,
  shownDecimals,
  Signal,
  stepFactor,
  tCount,
  textLocale,
  toRadians,
  valueText,
} from '@farol/editing';
import { es, esOfApps } from '@farol/editing/es';
import {
  allowedBy,
  choice,
  curve,
  curveAt,
  describeValue,
  type FieldKind,
  type FieldValue,
  fullKeys,
  isFieldValue,
  isTriple,
  MOST_KEYS,
  number,
  variantOfField,
} from '@farol/editing/fields';
import { Mesh, Object3D, Vector3 } from 'three';
import { expect, test } from 'vitest';

test('history', () => {
  const lamp = { ownerName: 'Lamp', fields: { range: number(5, { unit: 'm' }) }, range: 5 };
  const target = {
    ...lamp,
    getAuthored: () => lamp.range,
    set: (_name: string, value: FieldValue) => void (lamp.range = Number(value)),
  };
  const commands = new CommandStack();
  const drag = commands.begin();
  drag.preview(new SetFields('Set range', [{ owner: target, name: 'range', value: 7 }]));
  drag.preview(new SetFields('Set range', [{ owner: target, name: 'range', value: 9 }]));
  drag.commit(); // one step, whatever the number of previews
  commands.undo();
  expect(lamp.range).toBe(5);

  const next = { ...target };
  replaceOwner(target, next); // steps that name the old owner change the next one
});

test('signals and labels', () => {
  const changed = new Signal<[name: string]>();
  const end = changed.subscribe((name) => console.assert(name === 'range'));
  changed.emit('range');
  end();
  expect(changed.revision).toBe(1);

  expect(namesOf([{ name: 'Lamp' }, { name: 'Lamp' }])).toBe('2 objects');
  expect(Object.keys(sharedIcons)).toContain('undo');
});

test('numbers and fields in words', () => {
  expect(stepFactor({ shiftKey: true, altKey: false })).toBe(10);
  expect(shownDecimals.long).toBe(5);
  expect(toRadians(180)).toBe(Math.PI);
  expect(englishLabelOfField('castShadow', {})).toBe('Cast shadow');
  expect(valueText(number(5, { unit: 'm' }), 7)).toBe('7 m');
});

test('keys', () => {
  expect(latinKey({ key: 'ы', code: 'KeyS' })).toBe('s');
  expect(isComposing({ isComposing: true, keyCode: 13 })).toBe(true);
});

test('languages', () => {
  setTexts({ ...es, ...esOfApps }, 'es');
  expect(textLocale()).toBe('es');
  setTexts({});
  expect(tCount(2, '{count} light', '{count} lights')).toBe('2 lights');
});

test('a pivot for a gizmo', () => {
  const box = new Mesh();
  const pivot = new Object3D();
  placePivot(pivot, new Vector3(0, 1, 0), box.matrixWorld);
  expect(pivot.position.y).toBe(1);
});

test('field values', () => {
  const range = number(5, { unit: 'm', min: 0 });
  expect(allowedBy(range)).toBe('a finite number of at least 0 m');
  expect(describeValue([1, 'two'])).toBe('[1, "two"]');
  expect(isFieldValue([0, 1, 0])).toBe(true);
  expect(isTriple([0, 1, 0])).toBe(true);
  expect(MOST_KEYS).toBe(64);

  const kind: FieldKind = range.kind;
  expect(kind).toBe('number');
});

test('curves and gradients', () => {
  const size = curve([
    [0, 0],
    [1, 2],
  ]);
  expect(curveAt(size.default, 0.5)).toBe(1);

  const keys = fullKeys([[0, [1, 0.5, 0], 1]]);
  expect(keys).toEqual([[0, [1, 0.5, 0], 1]]);
});

test('a field whose label depends on another one', () => {
  const shape = choice('rectangle', ['rectangle', 'tube']);
  const width = number(1, { unit: 'm', variants: { field: 'shape', of: { tube: { label: 'Length' } } } });
  expect(variantOfField(width, () => shape.default)).toBe(width);
});
