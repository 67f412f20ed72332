import { getSurfaces } from '@farol/renderer/surfaces';
import type { Mesh } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { surfaceCode } from './surfaceCode';
import type { SurfaceAsset } from './SurfaceAsset';

const TEXT = `uniform float height; // = 0.2 [0, 1, 0.01] Height (m)
uniform vec3 rimColor; // = #ffffff Rim
uniform vec2 way; // = 1, 0 Way
uniform int count; // = 3 [1, 8]
uniform bool isOn; // = true
uniform sampler2D pattern; // Pattern
void displace(inout VertexData v) { v.positionOS.y += height * v.time; }
void surface(inout SurfaceData s) { s.color = rimColor; }
`;

/** A box with the material 'Sea', whose surface is 'Waves'. */
function worn() {
  const scene = new Scene();
  const { assets } = scene;
  const waves = assets.addFieldAsset('surface', 'Waves', { source: TEXT }) as SurfaceAsset;
  const sea = assets.addMaterial('Sea', { surface: 'Waves' });
  const object = new GameObject('Box');
  scene.add(object);
  const renderer = object.addComponent(ObjectRenderer, { mesh: 'box', material: 'Sea' });
  const uniforms = () => getSurfaces(sea.three)[0].uniforms;
  return { scene, assets, waves, sea, renderer, uniforms };
}

beforeAll(() => surfaceCode.load());

describe('a material that wears a surface', () => {
  test('has its uniforms as fields, whose values reach the renderer', () => {
    const { sea, uniforms, scene } = worn();
    expect(Object.keys(sea.fields).filter((name) => name.startsWith('surface.'))).toEqual([
      ...['surface.height', 'surface.rimColor', 'surface.way.x', 'surface.way.y'],
      ...['surface.count', 'surface.isOn', 'surface.pattern'],
    ]);
    expect(sea.fields['surface.height']).toMatchObject({
      kind: 'number',
      min: 0,
      max: 1,
      step: 0.01,
      label: 'Height (m)',
    });
    expect(sea.get('surface.height')).toBe(0.2);
    expect(uniforms().height.value).toBe(0.2);
    sea.set('surface.height', 0.5);
    sea.set('surface.rimColor', [1, 0, 0]);
    sea.set('surface.way.y', 2);
    sea.set('surface.pattern', 'brick');
    expect(uniforms().height.value).toBe(0.5);
    expect(uniforms().rimColor.value).toMatchObject({ r: 1, g: 0, b: 0 });
    expect(uniforms().way.value).toMatchObject({ x: 1, y: 2 });
    expect(uniforms().pattern.value).toBe(scene.assets.texture('brick'));
    expect(sea.get('surfaceMap1')).toBe('brick');
    expect(() => sea.set('surface.height', 2)).toThrow('Sea.surface.height must be a finite number from 0 to 1, not 2');
    expect(() => sea.set('surface.gone', 2)).toThrow('surface.gone is unknown');
    sea.set('surface.height', 0.2);
    sea.set('surface.way.y', 0);
    expect(sea.get('surfaceValues')).toBe('{"rimColor":[1,0,0]}');
    scene.dispose();
  });

  test('follows its text; one that cannot be read leaves the last good one', () => {
    const { assets, waves, sea, uniforms, renderer } = worn();
    const failures: string[] = [];
    assets.onChange((change) => change.kind === 'failed' && failures.push(change.error!.message));
    sea.set('surface.height', 0.5);
    expect((renderer.three as Mesh).frustumCulled).toBe(false);
    waves.set('source', 'uniform mat4 height;\nvoid surface(inout SurfaceData s) {}');
    expect(waves.problem?.message).toContain('"mat4" uniforms cannot be set');
    expect(failures).toHaveLength(1);
    expect(uniforms().height.value).toBe(0.5);
    // the fields depend on the present text alone
    expect(Object.keys(sea.fields).filter((name) => name.startsWith('surface.'))).toEqual([]);
    sea.set('roughness', 0.1);
    expect(uniforms().height.value).toBe(0.5);
    waves.set(
      'source',
      'uniform float more; // = 4\nuniform float height; // = 1\nvoid surface(inout SurfaceData s) {}',
    );
    expect(waves.problem).toBe(null);
    expect(sea.get('surface.more')).toBe(4);
    expect(uniforms().height.value).toBe(0.5);
    expect(sea.fields).not.toHaveProperty(['surface.count']);
    expect((renderer.three as Mesh).frustumCulled).toBe(true);
    sea.set('kind', 'phong');
    expect(uniforms().more.value).toBe(4);
    sea.set('surface', null);
    expect(getSurfaces(sea.three)).toEqual([]);
  });

  test('has the time of its scene', () => {
    const { scene, waves } = worn();
    scene.update(0.5);
    expect(waves.surface!.time.value).toBe(0.5);
    scene.reset();
    expect(waves.surface!.time.value).toBe(0);
  });

  test('goes through a file, whichever comes first in it', async () => {
    const { scene, sea } = worn();
    sea.set('surface.height', 0.75);
    sea.set('surface.pattern', 'brick');
    const file = serialize(scene);
    for (const assets of [file.assets, file.assets.toReversed()]) {
      const copy = await deserialize(JSON.stringify({ ...file, assets }));
      const again = copy.assets.materialAsset('Sea')!;
      expect(again.get('surface.height')).toBe(0.75);
      expect(again.get('surface.pattern')).toBe('brick');
      expect(getSurfaces(again.three)[0].uniforms.height.value).toBe(0.75);
      expect(copy.assets.surface('Waves')!.source).toBe(TEXT);
      expect(again.changedValues()).toEqual(sea.changedValues());
    }
  });

  test('wears it again after the surface, or its text, was taken out and put back', () => {
    const { assets, waves, sea, uniforms } = worn();
    const taken = assets.take('Waves');
    expect(sea.fields).not.toHaveProperty(['surface.height']);
    assets.restore(taken);
    expect(uniforms().height.value).toBe(0.2);
    expect(assets.rename('Waves', 'Sea/Waves').get('Waves')).toBe('Sea/Waves');
    sea.set('surface', 'Sea/Waves');
    expect(sea.get('surface.height')).toBe(0.2);
    expect(waves.name).toBe('Sea/Waves');
  });
});
