import { type ClipAsset, GameObject, Model, ModelRenderer, ObjectRenderer } from '@farol/engine';
import { BoxGeometry, Group, Mesh, MeshStandardMaterial } from 'three';
import { beforeAll, beforeEach, describe, expect, test } from 'vitest';
import { EditorDocument } from './EditorDocument';
import { addSurface, ownSurfaceValues, surfaceWearers, wearSurface } from './surfaceEdits';
import { loadSurfaces } from './testing/randomSurfaceCommand';
import { recordEdit } from './timeline/recordEdit';
import { animatableFields } from './timeline/trackTargets';
import { unpackModels } from './unpackModels';
import { SetFields } from '@farol/editing';
import { resetFields } from './edits';

const TEXT = `uniform float amount; // = 0.25 [0, 1] Amount
uniform vec3 rustColor; // = #ff0000 Rust
void surface(inout SurfaceData s) { s.color = mix(s.color, rustColor, amount); }
`;

beforeAll(loadSurfaces);

let document: EditorDocument;
const box = (name: string, values = {}): ObjectRenderer => {
  const object = new GameObject(name);
  document.scene.add(object);
  return object.addComponent(ObjectRenderer, { mesh: 'box', ...values });
};

beforeEach(() => {
  document = new EditorDocument();
  document.assets.addFieldAsset('surface', 'Rust', { source: TEXT });
});

describe('a surface on objects', () => {
  test('is worn by them alone, in one step; the material that they share stays as it is', () => {
    const { assets, commands } = document;
    const steel = assets.addMaterial('Steel');
    const [one, other] = [box('One', { material: 'Steel' }), box('Other', { material: 'Steel' })];
    commands.run(wearSurface('Rust', surfaceWearers([one.gameObject])));
    expect([one.surface, other.surface, steel.get('surface')]).toEqual(['Rust', null, null]);
    commands.undo();
    expect(one.surface).toBe(null);
  });

  test('takes over the values of the material, which become its own', () => {
    const { assets, commands } = document;
    const steel = assets.addMaterial('Steel', { surface: 'Rust' });
    steel.set('surface.amount', 0.75);
    const one = box('One', { material: 'Steel' });
    commands.run(ownSurfaceValues([one], steel));
    expect(one.get('surface.amount')).toBe(0.75);
    commands.run(new SetFields('Set', [{ owner: one, name: 'surface.amount', value: 0.5 }]));
    expect(steel.get('surface.amount')).toBe(0.75);
    // resets all fields, not only those of the surface
    commands.run(resetFields('Reset', [one]));
    expect(one.surface).toBe(null);
    commands.undo();
    expect(one.get('surface.amount')).toBe(0.5);
  });

  test('is made for models too, which wear it themselves, and keep it when they are unpacked', () => {
    const { assets, commands, scene } = document;
    const root = new Group();
    const body = new MeshStandardMaterial({ name: 'Body' });
    root.add(
      new Mesh(new BoxGeometry(), body),
      new Mesh(new BoxGeometry(), new MeshStandardMaterial({ name: 'Glass' })),
    );
    assets.register('car', new Model(root));
    root.children.forEach((child, i) => assets.register(`car/mesh-${i + 1}`, (child as Mesh).geometry));
    const object = new GameObject('Car');
    scene.add(object);
    const car = object.addComponent(ModelRenderer, { model: 'car' });
    const cube = box('Cube');
    const made = addSurface(scene, 'Snow', TEXT, { roughness: 1 }, [car, cube]);
    commands.run(made.command);
    expect(car.surface).toBe('Snow');
    expect([cube.material, cube.surface]).toEqual([made.material, null]);
    car.surfaceMaterial = 'Body';
    car.set('surface.amount', 1);
    commands.run(unpackModels(scene, [car]));
    const parts = object.children.map((child) => child.getComponent(ObjectRenderer)!);
    expect(parts.map(({ surface }) => surface)).toEqual(['Snow', null]);
    expect(parts[0].get('surface.amount')).toBe(1);
  });

  test('that moves vertices makes a grid of a plane, in the same step', () => {
    const { commands, scene } = document;
    const [plane, cube] = [box('Sea', { mesh: 'plane' }), box('Cube')];
    commands.run(addSurface(scene, 'Waves', TEXT, {}, [plane, cube], true).command);
    expect([plane.mesh, cube.mesh]).toEqual(['grid', 'box']);
    commands.undo();
    expect([plane.mesh, plane.material]).toEqual(['plane', null]);
  });

  test('its uniforms can be keyed: they are in the list of tracks, and edits are recorded', () => {
    const { assets } = document;
    const one = box('One', { surface: 'Rust' });
    const fields = animatableFields(one.gameObject).map(({ address }) => address.field);
    expect(fields).toContain('surface.amount');
    expect(fields).toContain('surface.rustColor');
    expect(fields).not.toContain('surfaceValues');
    const clip = assets.addFieldAsset('clip', 'Rusts', { duration: 2 }) as ClipAsset;
    const edit = new SetFields('Set', [{ owner: one, name: 'surface.amount', value: 0.5 }]);
    recordEdit(edit, { clip, root: one.gameObject, data: clip.clip, duration: 2, time: 1 }).do();
    expect(clip.clip.tracks).toMatchObject([
      {
        component: 'ObjectRenderer',
        field: 'surface.amount',
        keys: [
          { time: 0, value: 0.25 },
          { time: 1, value: 0.5 },
        ],
      },
    ]);
    expect(one.get('surface.amount')).toBe(0.25);
  });
});
