import { SetFields } from '@farol/editing';
import { builtinComponents, Component, ComponentRegistry, createRandom, GameObject, Light, Scene } from '@farol/engine';
import { component, type FieldValue, number } from '@farol/engine/fields';
import { serialize } from '@farol/engine/files';
import { beforeEach, describe, expect, it } from 'vitest';
import { addObject, deleteObjects, moveObjects } from './edits';
import { EditorDocument } from './EditorDocument';
import { RemoveAsset } from './commands/AddAssets';
import { addScript, renameScript } from './scriptEdits';
import { scriptTemplate } from './scriptTemplate';
import { scriptsInNode } from './testing/scriptsInNode';

/** Writes a field of its own and one of another component while it is simulated. */
class Flicker extends component({ beats: number(0, { help: 'Counts.' }) }) {
  static override readonly typeName: string = 'Flicker';
  override update(_delta: number, time: number): void {
    this.beats += 1;
    const light = this.gameObject.getComponent(Light);
    if (light) light.intensity = 1 + Math.sin(time);
  }
}

const registry = new ComponentRegistry([...builtinComponents.types.values(), Flicker]);
let document: EditorDocument;
let lamp: GameObject;
let light: Light;

beforeEach(() => {
  document = new EditorDocument();
  const scene = new Scene({ name: 'Play', assets: document.assets, registry });
  lamp = new GameObject('Lamp');
  light = lamp.addComponent(Light, { type: 'point', intensity: 7 });
  scene.add(lamp).add(new GameObject('Other'));
  document.open(scene);
});

const state = (): string => JSON.stringify(serialize(document.scene));
const set = (owner: Component, name: string, value: FieldValue): void =>
  document.commands.run(new SetFields(`Set ${name}`, [{ owner, name, value }]));

describe('edits while playing', () => {
  it('leave no asset that a script has registered', async () => {
    const scripted = new EditorDocument(
      undefined,
      new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true }),
      scriptsInNode(),
    );
    const { assets, scene, simulation, scripts } = scripted;
    const source = `import { component } from '@farol/engine/fields';
import { BoxGeometry, MeshBasicMaterial } from 'three';
export default class Maker extends component({}) {
  start(): void {
    const { assets } = this.scene;
    assets.register('made', new BoxGeometry());
    assets.registerMaker('made late', 'material', () => new MeshBasicMaterial());
    assets.addMaterial('made of fields');
  }
}`;
    assets.addFieldAsset('script', 'Maker', { source });
    await scripts.settled();
    const maker = new GameObject('Maker');
    scene.add(maker);
    maker.addComponent('Maker');
    const before = assets.list();
    // twice: assets of the first run must not conflict with those of the second
    for (let i = 0; i < 2; i++) {
      simulation.play();
      simulation.advance(0.05);
      expect(assets.list()).toEqual([...before, 'made', 'made late', 'made of fields']);
      let isDisposed = false;
      assets.mesh('made').addEventListener('dispose', () => (isDisposed = true));
      scripted.commands.run(addScript(scene, 'Kept').command);
      simulation.stop();
      expect(isDisposed).toBe(true);
      before.push(i === 0 ? 'Kept' : 'Kept 2');
      expect(assets.list()).toEqual(before);
    }
  });

  it('are taken back by stopping, with what components wrote, and kept one by one', () => {
    lamp.addComponent(Flicker);
    set(light, 'range', 3);
    const { commands, simulation, playEdits } = document;
    const before = state();
    const steps = commands.history;
    simulation.play();
    simulation.advance(0.05);
    expect(light.intensity).not.toBe(7);
    set(light, 'range', 9);
    set(light, 'decay', 1);
    set(light, 'range', 5);
    expect(commands.history.length).toBe(4);
    simulation.advance(0.05);
    simulation.stop();
    expect(state()).toBe(before);
    expect(commands.history).toEqual(steps);
    expect(playEdits.changes.map(({ name, from, to }) => [name, from, to])).toEqual([
      ['decay', 2, 1],
      ['range', 3, 5],
    ]);
    playEdits.keep(playEdits.changes[1]);
    expect(light.range).toBe(5);
    expect(commands.history).toEqual([...steps, 'Kept range of Lamp']);
    expect(playEdits.changes.map(({ name }) => name)).toEqual(['decay']);
    commands.undo();
    expect(state()).toBe(before);
    playEdits.dismiss();
    expect(playEdits.changes).toEqual([]);
  });

  it('can be undone while it plays, those from before cannot', () => {
    const { commands, simulation } = document;
    set(light, 'range', 3);
    simulation.step();
    expect(commands.undoLabel).toBeNull();
    expect(commands.undo()).toBe(false);
    set(light, 'range', 4);
    expect(commands.undo()).toBe(true);
    expect(commands.undo()).toBe(false);
    simulation.stop();
    expect(commands.undo()).toBe(true);
  });

  it('that are kept go back to the values that there were then, which a script’s new text may have changed', () => {
    const { commands, simulation, playEdits } = document;
    simulation.play();
    set(light, 'range', 4);
    simulation.stop();
    light.set('range', 2);
    playEdits.keepAll();
    expect(light.get('range')).toBe(4);
    commands.undo();
    expect(light.get('range')).toBe(2);
  });

  it('that are no values are kept with all others, as one step', () => {
    const { commands, simulation, playEdits, scene } = document;
    const before = state();
    simulation.play();
    const added = new GameObject('Added');
    const addedLight = added.addComponent(Light);
    commands.run(addObject(scene, added, scene, []));
    set(addedLight, 'intensity', 3);
    commands.run(deleteObjects(scene, [scene.find('Other')!]));
    commands.run(moveObjects(scene, [lamp], added));
    set(light, 'range', 4);
    const played = state();
    simulation.stop();
    expect(state()).toBe(before);
    expect(playEdits.others).toEqual(['Added Added', 'Deleted Other', 'Moved Lamp into Added']);
    expect(() => playEdits.keep(playEdits.changes[0])).toThrow(/was added while playing/);
    playEdits.keepAll();
    expect(state()).toBe(played);
    expect(commands.history).toEqual(['Kept the edits made while playing']);
    commands.undo();
    expect(state()).toBe(before);
    commands.redo();
    expect(state()).toBe(played);
  });

  it('of a script take back what its text threw; steps, pauses and the end do not', async () => {
    const text = (act: string): string => `import { component } from '@farol/engine/fields';
export default class Worker extends component({}) {
  update() { ${act} }
}`;
    document = new EditorDocument(undefined, undefined, scriptsInNode());
    const { scene, scripts, simulation, assets } = document;
    const script = assets.addFieldAsset('script', 'Worker', { source: text("throw new Error('no lamp');") });
    await scripts.settled();
    const house = new GameObject('House');
    scene.add(house);
    house.addComponent('Worker');
    const told = (): string[] => [...scripts.failures.values()].map(({ message }) => message);
    document.onComponentError = (each, error) => void scripts.note(each, error);
    simulation.step();
    expect(told()).toEqual(['no lamp']);
    simulation.play();
    simulation.pause();
    expect(told()).toEqual(['no lamp']);
    script.set('source', text('this.calls = 1;'));
    await scripts.settled();
    expect(told()).toEqual([]);
    simulation.stop();
    script.set('source', text("throw new Error('no lamp');"));
    await scripts.settled();
    simulation.step();
    simulation.stop();
    expect(told()).toEqual(['no lamp']);
  });

  it('of scripts stay when the scene stops, as steps; what scripts did is taken back', async () => {
    const text = (act: string): string => `import { component } from '@farol/engine/fields';
export default class Worker extends component({}) {
  update() { ${act} }
}`;
    document = new EditorDocument(undefined, undefined, scriptsInNode());
    const { scene, scripts, commands, simulation, assets } = document;
    const house = new GameObject('House');
    scene.add(house.add(new GameObject('Door')));
    const source = text("this.gameObject.name = 'Other'; this.gameObject.children[0]?.dispose();");
    const script = assets.addFieldAsset('script', 'Worker', { source });
    await scripts.settled();
    house.addComponent('Worker');
    const before = state();
    simulation.play();
    simulation.advance(0.05);
    expect([house.name, house.children]).toEqual(['Other', []]);
    commands.run(new SetFields('Edited script', [{ owner: script, name: 'source', value: text('this.calls = 1;') }]));
    set(house.transform, 'position', [1, 2, 3]);
    await scripts.settled();
    simulation.advance(0.05);
    expect(house.getComponent('Worker')).toMatchObject({ calls: 1 });
    simulation.stop();
    expect(house.getComponent('Worker')).not.toHaveProperty('calls');
    expect(commands.history).toEqual(['Edited script']);
    expect(document.playEdits.changes.map(({ name }) => name)).toEqual(['position']);
    commands.undo();
    expect(state()).toBe(before);
  });

  it('of scripts that need others of the play are undone with them: one that was renamed and deleted', async () => {
    document = new EditorDocument(undefined, undefined, scriptsInNode());
    const { scene, scripts, commands, simulation, assets, playEdits } = document;
    assets.addFieldAsset('script', 'Worker', { source: scriptTemplate('Worker') });
    await scripts.settled();
    const before = state();
    simulation.play();
    commands.run(renameScript(scene, 'Worker', 'Idler'));
    commands.run(new RemoveAsset(assets, 'Idler'));
    simulation.stop();
    expect(simulation.state).toBe('stopped');
    expect(state()).toBe(before);
    expect(playEdits.others).toEqual(['Renamed Worker to Idler', 'Deleted Idler']);
    playEdits.keepAll();
    expect(assets.fieldAssets('script')).toEqual([]);
    commands.undo();
    expect(state()).toBe(before);
  });

  it.each([1, 2, 3])('leave the scene exactly as it was, whatever is done (seed %i)', (seed) => {
    const random = createRandom(seed);
    const { commands, simulation, playEdits, scene } = document;
    for (let round = 0; round < 40; round++) {
      const before = state();
      simulation.play();
      for (let i = 0; i < 8; i++) {
        simulation.advance(0.03);
        const act = random();
        if (act < 0.3) set(light, 'range', Math.round(random() * 9));
        else if (act < 0.5) commands.run(addObject(scene, new GameObject('New'), random() < 0.5 ? scene : lamp, []));
        else if (act < 0.7 && scene.roots.length > 1) commands.run(deleteObjects(scene, [scene.roots.at(-1)!]));
        else if (act < 0.85) commands.undo();
        else commands.redo();
      }
      const played = state();
      simulation.stop();
      expect(state()).toBe(before);
      if (random() < 0.5 && playEdits.canKeepAll) {
        playEdits.keepAll();
        expect(state()).toBe(played);
        commands.undo();
        expect(state()).toBe(before);
        if (random() < 0.5) commands.redo();
      }
    }
  });
});
