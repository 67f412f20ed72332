import { Animation, type ClipAsset, GameObject, Light } from '@farol/engine';
import { beforeEach, expect, test } from 'vitest';
import { deleteObjects, moveObjects, renameObject } from '../edits';
import { EditorDocument } from '../EditorDocument';
import { groupObjects, ungroupObjects } from '../groupObjects';

let document: EditorDocument;
let clip: ClipAsset;
let machine: GameObject;
let arm: GameObject;
let lamp: GameObject;

const track = (path: string) => ({
  path,
  component: 'Transform',
  field: 'position',
  keys: [{ time: 0.5, value: [1, 2, 3] as const }],
});

/** An animated object with an arm, and a lamp on the arm. */
function machineOf(name: string): GameObject {
  const root = new GameObject(name);
  root.addComponent(Animation, { clip: 'Move' });
  const inner = new GameObject('Arm');
  const outer = new GameObject('Lamp');
  outer.addComponent(Light);
  inner.add(outer);
  root.add(inner);
  document.scene.add(root);
  return root;
}

beforeEach(() => {
  document = new EditorDocument();
  clip = document.assets.addFieldAsset('clip', 'Move') as ClipAsset;
  clip.setData({ tracks: [track(''), track('Arm'), track('Arm/Lamp'), track('Gone')], events: [] });
  machine = machineOf('Machine');
  [arm] = machine.children;
  [lamp] = arm.children;
});

const paths = (): string[] => clip.clip.tracks.map(({ path }) => path);

/** Runs a command and returns the tracks' paths, after checking that undo and redo are one step. */
function pathsAfter(command: ReturnType<typeof renameObject>): string[] {
  const before = document.serialize();
  document.commands.run(command);
  const [after, found] = [document.serialize(), paths()];
  expect(document.commands.history).toHaveLength(1);
  document.commands.undo();
  expect(document.serialize()).toBe(before);
  document.commands.redo();
  expect(document.serialize()).toBe(after);
  return found;
}

test('tracks follow an object that is renamed, and those below it', () => {
  expect(pathsAfter(renameObject(arm, 'Left/arm'))).toEqual(['', 'Left/arm', 'Left/arm/Lamp', 'Gone']);
});

test('an object at the root of the clip is renamed without its tracks', () => {
  expect(pathsAfter(renameObject(machine, 'Crane'))).toEqual(['', 'Arm', 'Arm/Lamp', 'Gone']);
});

test('tracks follow into another parent, a group and out of it', () => {
  const scene = document.scene;
  expect(pathsAfter(moveObjects(scene, [lamp], machine))).toEqual(['', 'Arm', 'Lamp', 'Gone']);
  document.commands.undo();
  document.commands.run(groupObjects(scene, [lamp]));
  expect(paths()).toEqual(['', 'Arm', 'Arm/Group/Lamp', 'Gone']);
  document.commands.run(ungroupObjects(scene, [lamp.parent!]));
  expect(paths()).toEqual(['', 'Arm', 'Arm/Lamp', 'Gone']);
});

test('tracks of what left the animated object stay as they are, and are told of', () => {
  expect(pathsAfter(moveObjects(document.scene, [arm], document.scene))).toEqual(['', 'Arm', 'Arm/Lamp', 'Gone']);
  const told: string[] = [];
  document.scene.onComponentError = (component, error) =>
    told.push(`${component.gameObject.name}: ${(error as Error).message}`);
  document.scene.update(0.1);
  expect(told.filter((each) => each.includes("'Machine/Arm'"))).toEqual([
    "Machine: The clip 'Move': the object 'Machine/Arm' is gone: give an object this name, or take its tracks out.",
  ]);
});

test('a clip that moves several objects follows what happens to all of them', () => {
  machineOf('Machine 2');
  expect(pathsAfter(renameObject(arm, 'Hand'))).toEqual(['', 'Arm', 'Arm/Lamp', 'Gone']);
});

test('a track that is there already is not doubled; nothing follows what is deleted', () => {
  expect(pathsAfter(renameObject(lamp, 'Gone'))).toEqual(['', 'Arm', 'Arm/Gone', 'Gone']);
  document.commands.run(moveObjects(document.scene, [lamp], machine));
  expect(paths()).toEqual(['', 'Arm', 'Arm/Gone', 'Gone']);
  document.commands.run(deleteObjects(document.scene, [arm]));
  expect(paths()).toEqual(['', 'Arm', 'Arm/Gone', 'Gone']);
});
