import { SetFields } from '@farol/editing';
import { Animation, type ClipAsset, GameObject, Light } from '@farol/engine';
import { beforeEach, describe, expect, test } from 'vitest';
import { EditorDocument } from '../EditorDocument';
import { moveObjects, setValues } from '../edits';
import { addClip } from './clipEdits';
import { clipPlayer } from './clipPlayer';
import { keyId, trackId } from './clipTracks';
import { allKeys, moveKeys } from './editKeys';
import { Timeline } from './Timeline';
import { deleteSelected, keyTransforms } from './timelineEdits';

let document: EditorDocument;
let timeline: Timeline;
let cube: GameObject;
let lamp: GameObject;

const position = { path: '', component: 'Transform', field: 'position' };

/** Waits for the microtask in which the timeline notices edits. */
const noticed = (): Promise<void> => Promise.resolve();

const place = (object: GameObject): readonly number[] => object.transform.get('position') as readonly number[];
const authored = (object: GameObject): unknown => object.transform.getAuthored('position');

beforeEach(() => {
  document = new EditorDocument();
  cube = new GameObject('Cube');
  lamp = new GameObject('Lamp');
  lamp.addComponent(Light, { intensity: 2 });
  cube.add(lamp);
  document.scene.add(cube);
  document.selection.set([cube.id]);
  timeline = new Timeline(document, () => {});
  timeline.open();
  const made = addClip(document.scene, 'Walk', cube, clipPlayer(document.scene));
  document.commands.run(made.command);
});

const record = (): void => timeline.setRecording(true);
const move = (object: GameObject, value: readonly [number, number, number]): void =>
  document.commands.run(setValues('Move', [object.transform], { position: value }));

test('a new clip brings its Animation, as one step', () => {
  expect(document.commands.history).toHaveLength(1);
  expect(cube.getComponent(Animation)!.clip).toBe('Walk');
  expect([timeline.clip?.name, timeline.root]).toEqual(['Walk', cube]);
  document.commands.undo();
  expect(cube.getComponent(Animation)).toBeNull();
  expect(document.assets.has('Walk')).toBe(false);
  expect([timeline.clip, timeline.root]).toEqual([null, null]);
  document.commands.redo();
  expect(timeline.clip?.name).toBe('Walk');
});

describe('recording', () => {
  test('makes keys of edits, and leaves the authored values', async () => {
    const before = document.serialize();
    record();
    move(cube, [1, 0, 0]);
    timeline.setTime(2);
    move(cube, [5, 0, 0]);
    expect(authored(cube)).toEqual([0, 0, 0]);
    expect(timeline.data.tracks).toEqual([
      {
        ...position,
        keys: [
          { time: 0, value: [1, 0, 0] },
          { time: 2, value: [5, 0, 0] },
        ],
      },
    ]);
    expect(timeline.duration).toBe(2);
    await noticed();
    expect(place(cube)).toEqual([5, 0, 0]);
    timeline.setTime(1);
    expect(place(cube)).toEqual([3, 0, 0]);
    document.commands.undo();
    document.commands.undo();
    expect(document.serialize()).toBe(before);
  });

  test('a new track begins with what was authored', () => {
    timeline.setTime(1);
    record();
    document.commands.run(setValues('Dim', [lamp.getComponent(Light)!], { intensity: 7 }));
    expect(timeline.data.tracks[0]).toEqual({
      path: 'Lamp',
      component: 'Light',
      field: 'intensity',
      keys: [
        { time: 0, value: 2 },
        { time: 1, value: 7 },
      ],
    });
  });

  test('a drag is one step, of its last preview alone', () => {
    record();
    const steps = document.commands.history.length;
    const gesture = document.commands.begin();
    const edit = (name: string, value: [number, number, number]): SetFields =>
      new SetFields('Drag', [{ owner: cube.transform, name, value }]);
    gesture.preview(edit('scale', [2, 2, 2]));
    gesture.preview(edit('position', [1, 1, 1]));
    gesture.preview(edit('position', [2, 2, 2]));
    gesture.commit();
    expect(document.commands.history).toHaveLength(steps + 1);
    expect(timeline.data.tracks).toEqual([{ ...position, keys: [{ time: 0, value: [2, 2, 2] }] }]);
  });

  test('edits begin from what is seen', async () => {
    record();
    move(cube, [5, 0, 0]);
    await noticed();
    expect(document.commands.valueOf(cube.transform, 'position')).toEqual([5, 0, 0]);
    timeline.setRecording(false);
    expect(document.commands.valueOf(cube.transform, 'position')).toEqual([0, 0, 0]);
  });

  test('what is not below the object, and no animated field, is edited as ever', () => {
    const other = new GameObject('Other');
    document.scene.add(other);
    record();
    document.commands.run(setValues('Move', [cube.transform, other.transform], { position: [3, 3, 3] }));
    expect([authored(other), authored(cube)]).toEqual([
      [3, 3, 3],
      [0, 0, 0],
    ]);
    expect(timeline.data.tracks).toHaveLength(1);
    document.commands.undo();
    expect([authored(other), timeline.data.tracks]).toEqual([[0, 0, 0], []]);
  });
});

describe('the preview', () => {
  const twoKeys = (): void => {
    record();
    move(cube, [0, 0, 0]);
    timeline.setTime(1);
    move(cube, [10, 0, 0]);
    timeline.setRecording(false);
  };

  test('is no edit, is not saved, and ends when the panel is left', () => {
    twoKeys();
    const [text, { revision }] = [document.serialize(), document.scene];
    timeline.setTime(0.5);
    expect(place(cube)).toEqual([5, 0, 0]);
    expect(document.serialize()).toBe(text);
    expect(document.scene.revision).toBe(revision);
    timeline.close();
    expect(place(cube)).toEqual([0, 0, 0]);
    expect(document.commands.recorder).toBeNull();
  });

  test('stays while a part of the object is selected, and ends when another object is', () => {
    twoKeys();
    timeline.setTime(0.5);
    document.selection.set([lamp.id]);
    expect(place(cube)).toEqual([5, 0, 0]);
    const other = new GameObject('Other');
    document.scene.add(other);
    document.selection.set([other.id]);
    expect(place(cube)).toEqual([0, 0, 0]);
    expect([timeline.root, timeline.clip]).toEqual([null, null]);
  });

  test('ends when an animated field is edited without recording, which edits what was authored', () => {
    twoKeys();
    timeline.setTime(0.5);
    move(cube, [0, 4, 0]);
    expect(timeline.isPreviewing).toBe(false);
    expect([authored(cube), place(cube)]).toEqual([
      [0, 4, 0],
      [0, 4, 0],
    ]);
  });

  test('is not read by commands that move objects in the tree, nor by their undo and redo', async () => {
    twoKeys();
    timeline.setTime(1);
    const other = new GameObject('Other');
    document.scene.add(other);
    document.commands.run(moveObjects(document.scene, [lamp], other));
    expect(authored(lamp)).toEqual([0, 0, 0]);
    await noticed();
    expect(place(cube)).toEqual([10, 0, 0]);
    const moved = document.serialize();
    document.commands.undo();
    await noticed();
    expect([place(cube), authored(lamp)]).toEqual([
      [10, 0, 0],
      [0, 0, 0],
    ]);
    document.commands.redo();
    expect(document.serialize()).toBe(moved);
  });

  test('follows an undo of keys, and a clip that plays', async () => {
    twoKeys();
    timeline.setTime(1);
    document.commands.undo();
    await noticed();
    expect(place(cube)).toEqual([0, 0, 0]);
    document.commands.redo();
    timeline.setTime(0);
    timeline.play();
    timeline.advance(0.25);
    expect(place(cube)).toEqual([2.5, 0, 0]);
    timeline.advance(1);
    expect(timeline.time).toBeCloseTo(0.25);
  });

  test('gives way to the scene that plays, which the playhead follows', () => {
    twoKeys();
    timeline.setTime(0.5);
    document.simulation.play();
    expect([timeline.isPreviewing, place(cube)[0]]).toEqual([false, 0]);
    document.simulation.advance(0.05);
    timeline.advance(0.05);
    expect(timeline.time).toBeCloseTo(0.05);
    document.simulation.stop();
    expect(authored(cube)).toEqual([0, 0, 0]);
    expect(place(cube)).toEqual([0, 0, 0]);
  });
});

describe('selected keys', () => {
  beforeEach(() => {
    record();
    move(cube, [1, 0, 0]);
    timeline.setTime(0.5);
    move(cube, [2, 0, 0]);
    timeline.setRecording(false);
  });

  test('are followed through a drag, its undo and its redo', async () => {
    await noticed();
    const id = (time: number): string => keyId(trackId(position), time);
    timeline.select(new Set([id(0.5)]));
    const drag = timeline.beginEdit()!;
    drag.preview('Drag', moveKeys(drag.data, timeline.selection.keys, 0.2));
    drag.preview('Drag', moveKeys(drag.data, timeline.selection.keys, 0.25));
    drag.commit();
    await noticed();
    expect([...timeline.selection.keys]).toEqual([id(0.75)]);
    document.commands.undo();
    await noticed();
    expect([...timeline.selection.keys]).toEqual([id(0.5)]);
    document.commands.redo();
    await noticed();
    expect([...timeline.selection.keys]).toEqual([id(0.75)]);
  });

  test('are deleted in one step', async () => {
    await noticed();
    timeline.select(allKeys(timeline.data));
    deleteSelected(timeline);
    expect(timeline.data.tracks).toEqual([]);
    expect(document.commands.undoLabel).toBe('Deleted 2 keys of Walk');
    expect((timeline.clip as ClipAsset).getAuthored('data')).toBe('');
  });

  test('keys of the selected objects are added at the playhead', () => {
    document.selection.set([lamp.id]);
    expect(keyTransforms(timeline)).toBe(true);
    expect(timeline.data.tracks.map(({ path, field }) => `${path}.${field}`)).toEqual([
      '.position',
      'Lamp.position',
      'Lamp.rotation',
      'Lamp.scale',
    ]);
  });
});
