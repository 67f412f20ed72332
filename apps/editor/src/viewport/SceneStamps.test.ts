import { GameObject, Light, LightGroup } from '@farol/engine';
import { describe, expect, it, vi } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { setValues } from '../model/edits';
import { SceneStamps } from './SceneStamps';

function street() {
  const document = new EditorDocument();
  const { scene, commands } = document;
  const [lamp, desk] = ['Lamp', 'Desk'].map((name) => new GameObject(name));
  scene.add(lamp).add(desk);
  const light = lamp.addComponent(Light, { group: desk.id });
  const group = desk.addComponent(LightGroup);
  const ask = vi.fn<() => void>();
  const stamps = new SceneStamps(document, ask);
  /** Growth of `places` and `icons` by an edit, and whether it requests a frame. */
  const grown = (edit: () => void): readonly [number, number, boolean] => {
    const { places, icons } = stamps;
    ask.mockClear();
    edit();
    return [stamps.places - places, stamps.icons - icons, ask.mock.calls.length > 0];
  };
  return { document, scene, commands, lamp, light, group, stamps, grown };
}

describe('stamps of a scene', () => {
  it('stay while lights change their light alone; a frame is asked for all the same', () => {
    const { commands, document, light, group, lamp, grown } = street();
    expect(grown(() => commands.run(setValues('Dim', [light], { intensity: 3 })))).toEqual([0, 0, true]);
    expect(grown(() => commands.run(setValues('Dim', [group], { dimmer: 0.5 })))).toEqual([0, 0, true]);
    expect(grown(() => document.selection.set([lamp.id]))).toEqual([0, 0, true]);
    expect(grown(() => commands.run(setValues('Tint', [light], { diffuse: [1, 0, 0] })))).toEqual([0, 1, true]);
    expect(grown(() => (light.enabled = false))).toEqual([0, 1, true]);
  });

  it('grow with whatever else is edited, and with each redraw that is asked for from elsewhere', () => {
    const { commands, document, scene, lamp, light, stamps, grown } = street();
    expect(grown(() => commands.run(setValues('Move', [lamp.transform], { position: [1, 2, 3] })))[0]).toBe(1);
    expect(grown(() => commands.run(setValues('Set', [light], { type: 'spot' })))[0]).toBe(1);
    expect(grown(() => scene.add(new GameObject('Late')))[0]).toBe(1);
    expect(grown(() => document.simulation.play())).toEqual([expect.any(Number), 0, true]);
    expect(grown(() => stamps.redraw())).toEqual([1, 0, true]);
  });

  it('let a frame look at matrices only where objects may have moved, and once for all views', () => {
    const { commands, scene, lamp, light, stamps } = street();
    const updates: boolean[] = [];
    const draw = (): void =>
      stamps.draw(scene.three, () => {
        updates.push(scene.three.matrixWorldAutoUpdate);
      });
    draw();
    draw();
    commands.run(setValues('Dim', [light], { intensity: 3 }));
    draw();
    commands.run(setValues('Move', [lamp.transform], { position: [1, 2, 3] }));
    expect(() =>
      stamps.draw(scene.three, () => {
        throw new Error('a broken frame');
      }),
    ).toThrow('a broken frame');
    draw();
    draw();
    expect(updates).toEqual([true, false, false, true, false]);
    expect(scene.three.matrixWorldAutoUpdate).toBe(true);
  });
});
