import { checkFieldValue, type Field, type FieldValue, sameValue } from '@farol/editing/fields';
import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { sectionsOf } from './sectionsOf';

const materials = [
  THREE.MeshBasicMaterial,
  THREE.MeshLambertMaterial,
  THREE.MeshPhongMaterial,
  THREE.MeshStandardMaterial,
  THREE.MeshPhysicalMaterial,
  THREE.MeshToonMaterial,
  THREE.PointsMaterial,
  THREE.LineBasicMaterial,
  THREE.SpriteMaterial,
  THREE.ShaderMaterial,
];
const objects: THREE.Object3D[] = [
  new THREE.Group(),
  new THREE.AmbientLight(),
  new THREE.HemisphereLight(),
  new THREE.DirectionalLight(),
  new THREE.PointLight(),
  new THREE.SpotLight(),
  new THREE.RectAreaLight(),
  new THREE.PerspectiveCamera(),
  new THREE.OrthographicCamera(),
  ...materials.map((Type) => new THREE.Mesh(new THREE.BufferGeometry(), new Type())),
];

/** A different value that the field allows. */
function other(field: Field, value: FieldValue): FieldValue {
  switch (field.kind) {
    case 'number': {
      const step = field.integer ? 1 : 0.25;
      return checkFieldValue(field, (value as number) + step) === null
        ? (value as number) + step
        : (value as number) - step;
    }
    case 'angle':
      return 0.5;
    case 'boolean':
      return !value;
    case 'choice':
      return field.options.find((option) => option !== value)!;
    case 'string':
      return `${value as string}x`;
    default:
      return [0.25, 0.5, 0.75];
  }
}

describe('the properties of three objects', () => {
  it.each(objects.map((object) => [sectionsOf([object]).at(-1)!.title, object] as const))(
    '%s: each is read, set and put back as it was',
    (_title, object) => {
      for (const { title, owners } of sectionsOf([object])) {
        const [owner] = owners;
        for (const [name, field] of Object.entries(owner.fields)) {
          const before = owner.getAuthored(name);
          expect(checkFieldValue(field, before), `${title}, ${name}`).toBeNull();
          const after = other(field, before);
          expect(checkFieldValue(field, after), `${title}, ${name}`).toBeNull();
          owner.set(name, after);
          expect(sameValue(owner.getAuthored(name), after), `${title}, ${name}`).toBe(true);
          owner.set(name, before);
          expect(sameValue(owner.getAuthored(name), before), `${title}, ${name}`).toBe(true);
        }
      }
    },
  );

  it('shows what a kind has, and no more', () => {
    const names = (object: THREE.Object3D) =>
      sectionsOf([object]).flatMap(({ owners }) => Object.keys(owners[0].fields));
    expect(names(new THREE.SpotLight())).toEqual(expect.arrayContaining(['color', 'angle', 'penumbra', 'distance']));
    expect(names(new THREE.PointLight())).not.toContain('angle');
    expect(names(new THREE.Mesh(undefined, new THREE.MeshBasicMaterial()))).not.toContain('roughness');
  });

  it('shows a material that two groups share once', () => {
    const [a, b] = [new THREE.MeshBasicMaterial(), new THREE.MeshBasicMaterial()];
    expect(sectionsOf([new THREE.Mesh(undefined, [a, b, a])])).toHaveLength(4);
  });

  it('has another program compiled where an edit needs it, and nowhere else', () => {
    const compiled = (material: THREE.Material): string[] => {
      const [owner] = sectionsOf([new THREE.Mesh(undefined, material)]).at(-1)!.owners;
      return Object.entries(owner.fields).flatMap(([name, field]) => {
        const { version } = material;
        owner.set(name, other(field, owner.getAuthored(name)));
        return material.version > version ? [name] : [];
      });
    };
    const always = ['transparent', 'alphaTest', 'side'];
    expect(compiled(new THREE.MeshBasicMaterial())).toEqual(always);
    expect(compiled(new THREE.MeshStandardMaterial())).toEqual([...always, 'flatShading']);
    const layers = ['clearcoat', 'sheen', 'transmission'];
    expect(compiled(new THREE.MeshPhysicalMaterial())).toEqual([...layers, ...always, 'flatShading']);
  });

  it.each([new THREE.PerspectiveCamera(), new THREE.OrthographicCamera()])(
    'projects anew with each property of a $type',
    (camera) => {
      const { owners } = sectionsOf([camera]).at(-1)!;
      const names = Object.keys(owners[0].fields);
      expect(names).toEqual(expect.arrayContaining(['zoom', 'near', 'far']));
      for (const name of names) {
        const before = camera.projectionMatrix.toArray();
        owners[0].set(name, other(owners[0].fields[name], owners[0].getAuthored(name)));
        expect(camera.projectionMatrix.toArray(), name).not.toEqual(before);
      }
    },
  );

  it('moves objects whose matrix is set by hand', () => {
    const object = new THREE.Object3D();
    object.matrixAutoUpdate = false;
    sectionsOf([object])[0].owners[0].set('position', [1, 2, 3]);
    expect(object.matrix.elements.slice(12, 15)).toEqual([1, 2, 3]);
  });

  it('shows what several objects share, their materials as one', () => {
    const names = (...list: THREE.Object3D[]) =>
      sectionsOf(list).map(({ title, owners }) => `${title} ${Object.keys(owners[0].fields).length}`);
    const lamps = [new THREE.PointLight(), new THREE.SpotLight()];
    expect(names(...lamps)).toEqual(['Transform 3', 'Object 6', 'Light 4']);
    expect(names(new THREE.PointLight(), new THREE.PointLight())[2]).toBe('PointLight 4');
    expect(names(lamps[0], new THREE.Group())).toEqual(['Transform 3', 'Object 6']);
    const [a, b] = [new THREE.MeshBasicMaterial(), new THREE.MeshStandardMaterial()];
    const meshes = [a, b].map((material) => new THREE.Mesh(undefined, material));
    const section = sectionsOf(meshes)[2];
    expect(section.title).toBe('2 materials');
    expect(section.owners[0].fields).not.toHaveProperty('roughness');
    [0.25, 0.5].forEach((opacity, i) => section.owners[i].set('opacity', opacity));
    expect([a.opacity, b.opacity]).toEqual([0.25, 0.5]);
  });

  it.each([
    ['a mesh and a group', new THREE.Mesh(), new THREE.Group()],
    ['a group and a mesh', new THREE.Group(), new THREE.Mesh()],
    ['a light and a mesh', new THREE.PointLight(), new THREE.Mesh()],
    ['a mesh and a light', new THREE.Mesh(), new THREE.PointLight()],
    ['a camera and a light', new THREE.PerspectiveCamera(), new THREE.PointLight()],
    ['a light and a camera', new THREE.PointLight(), new THREE.PerspectiveCamera()],
    ['a mesh and one of no material', new THREE.Mesh(), new THREE.Mesh(undefined, [])],
  ])('shows no section that only one of two objects has: %s', (_name, one, other) => {
    expect(sectionsOf([one, other]).map(({ title }) => title)).toEqual(['Transform', 'Object']);
  });
});
