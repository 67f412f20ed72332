import { GameObject, Light, LightGroup, ParticleEmitter } from '@farol/engine';
import { PerspectiveCamera } from 'three';
import { describe, expect, test } from 'vitest';
import { EditorDocument } from '../EditorDocument';
import { setValues } from '../edits';
import { makeLightGroup, moveToLightGroup } from './lightEdits';
import { lightCount } from './lightSource';
import { type LightRow, LightTable } from './LightTable';

function lit(count: number) {
  const document = new EditorDocument();
  const lights = Array.from({ length: count }, (_, i) => {
    const object = new GameObject(`Lamp ${i + 1}`);
    document.scene.add(object);
    return object.addComponent(Light, { intensity: (i * 7) % count, type: i % 3 === 0 ? 'spot' : 'point' });
  });
  const table = new LightTable(document);
  table.connect();
  return { document, lights, table };
}

const names = (rows: readonly LightRow[]): string[] =>
  rows.map((row) => (row.kind === 'rest' ? '-' : row.kind === 'group' ? `[${row.object.name}]` : row.object.name));

describe('rows', () => {
  test('are the lights by name, numbers in their order', () => {
    const { table } = lit(12);
    expect(names(table.rows).slice(0, 11).at(-1)).toBe('Lamp 11');
    table.sortBy('intensity');
    expect(names(table.rows).slice(0, 3)).toEqual(['Lamp 1', 'Lamp 8', 'Lamp 3']);
    table.sortBy('intensity');
    expect(names(table.rows)[0]).toBe('Lamp 6');
  });

  test('pass the words, the kind, the selection and the group', () => {
    const { table, document, lights } = lit(12);
    table.setFilter({ text: 'lamp 1' });
    expect(names(table.rows)).toEqual(['Lamp 1', 'Lamp 10', 'Lamp 11', 'Lamp 12']);
    table.setFilter({ kind: 'spot' });
    expect(names(table.rows)).toEqual(['Lamp 1', 'Lamp 10']);
    document.selection.set([lights[9].gameObject.id]);
    table.setFilter({ isSelected: true });
    expect(names(table.rows)).toEqual(['Lamp 10']);
    document.selection.clear();
    expect(names(table.rows)).toEqual([]);
  });

  test('stand below their groups, which fold; a filter hides groups without lights', () => {
    const { table, document, lights } = lit(4);
    document.commands.run(makeLightGroup(document.scene, lights.slice(0, 2), []));
    expect(names(table.rows)).toEqual(['[Light group]', 'Lamp 1', 'Lamp 2', '-', 'Lamp 3', 'Lamp 4']);
    const group = document.scene.componentsOf(LightGroup)[0].gameObject;
    expect(document.selection.ids).toEqual([group.id]);
    table.fold(group.id, true);
    expect(names(table.rows)).toEqual(['[Light group]', '-', 'Lamp 3', 'Lamp 4']);
    table.setFilter({ group: '' });
    expect(names(table.rows)).toEqual(['-', 'Lamp 3', 'Lamp 4']);
    document.commands.run(moveToLightGroup(lights.slice(2), group));
    expect(names(table.rows)).toEqual([]);
    document.commands.undo();
    document.commands.undo();
    table.setFilter({ group: null });
    expect(names(table.rows)).toEqual(['Lamp 1', 'Lamp 2', 'Lamp 3', 'Lamp 4']);
  });

  test('are sorted within their groups, which stand in the order of what they show in the column', () => {
    const { table, document, lights } = lit(4);
    const fire = new GameObject('Fire');
    document.scene.add(fire);
    const emitter = fire.addComponent(ParticleEmitter, { shine: true, capacity: 100, lightEvery: 8 });
    document.commands.run(makeLightGroup(document.scene, lights.slice(0, 2), []));
    document.commands.run(makeLightGroup(document.scene, [lights[2], emitter], []));
    const groups = (): string[] => names(table.rows).filter((name) => name.startsWith('['));
    expect(names(table.rows)).toEqual([
      ...['[Light group]', 'Lamp 1', 'Lamp 2', '[Light group 2]', 'Fire', 'Lamp 3'],
      ...['-', 'Lamp 4'],
    ]);
    table.sortBy('name');
    expect(groups()).toEqual(['[Light group 2]', '[Light group]']);
    table.sortBy('intensity');
    const [first] = document.scene.componentsOf(LightGroup);
    document.commands.run(setValues('Brighten', [first], { dimmer: 2 }));
    expect(groups()).toEqual(['[Light group 2]', '[Light group]']);
    table.sortBy('intensity');
    expect(groups()).toEqual(['[Light group]', '[Light group 2]']);
    const view = { camera: new PerspectiveCamera(), width: 640, height: 360 };
    table.measure(view);
    const costs = table.rows.map((row) => table.costOf(row));
    expect(costs[0] + costs[3] + costs[6]).toBeCloseTo(1, 9);
    expect([lightCount(emitter), lightCount(lights[0])]).toEqual([13, 1]);
  });

  test('stand still while a value is dragged, and are sorted at its end', () => {
    const { table, document, lights } = lit(4);
    table.sortBy('intensity');
    const before = table.rows;
    const gesture = document.commands.begin();
    gesture.preview(setValues('Dim', [lights[0]], { intensity: 100 }));
    expect(table.rows).toBe(before);
    gesture.commit();
    expect(names(table.rows).at(-1)).toBe('Lamp 1');
  });
});

describe('lights shown alone', () => {
  test('are a preview, which ends when the scene plays and when the table is closed', () => {
    const document = new EditorDocument();
    const lights = ['A', 'B'].map((name) => {
      const object = new GameObject(name);
      document.scene.add(object);
      return object.addComponent(Light);
    });
    const table = new LightTable(document);
    const close = table.connect();
    const file = document.serialize();
    const visible = (): boolean[] => lights.map(({ three }) => three.visible);
    table.setSolo([lights[0]], true);
    expect([visible(), document.serialize(), document.commands.history]).toEqual([[true, false], file, []]);
    document.simulation.play();
    expect(visible()).toEqual([true, true]);
    document.simulation.stop();
    table.setSolo([lights[1]], true);
    expect(visible()).toEqual([false, true]);
    close();
    expect([visible(), table.hasSolo]).toEqual([[true, true], false]);
  });
});

describe('10,000 lights', () => {
  test('a master over 1,000 is dragged: rows are made once, listeners told once a task, one step', async () => {
    const { table, document, lights } = lit(10_000);
    document.commands.run(makeLightGroup(document.scene, lights.slice(0, 1000), []));
    const { rows, evaluations } = table;
    expect([rows.length, evaluations]).toEqual([10_002, 1]);
    const [group] = document.scene.componentsOf(LightGroup);
    const steps = document.commands.history.length;
    await Promise.resolve();
    let [told, arranged] = [0, 0];
    table.changed.subscribe(() => told++);
    table.arranged.subscribe(() => arranged++);
    const gesture = document.commands.begin();
    for (let i = 1; i <= 60; i++) {
      gesture.preview(setValues('Dim', [group], { dimmer: 1 - i / 60 }));
      expect(table.rows).toBe(rows);
      await Promise.resolve();
    }
    gesture.commit();
    expect([table.evaluations, told, arranged, document.commands.history.length - steps]).toEqual([1, 60, 0, 1]);
    expect(lights[999].three.intensity).toBe(0);
    expect(lights[1000].three.intensity).toBe(7000);
  });

  test('an edit of 1,000 selected rows is one step, and told once', async () => {
    const { table, document, lights } = lit(10_000);
    document.selection.set(lights.slice(0, 1000).map(({ gameObject }) => gameObject.id));
    expect(table.rows).toHaveLength(10_000);
    const edited = table.editedBy(lights[5]);
    expect(edited).toHaveLength(1000);
    expect(table.editedBy(lights[5000])).toEqual([lights[5000]]);
    await Promise.resolve();
    let told = 0;
    table.changed.subscribe(() => told++);
    document.commands.run(setValues('Set', edited, { intensity: 3 }));
    await Promise.resolve();
    expect([told, table.evaluations, document.commands.history]).toEqual([1, 1, ['Set']]);
    document.commands.undo();
    expect(lights[1].intensity).toBe(7);
  });
});
