import { AssetLibrary, GameObject, ObjectRenderer, objectsOfModel, Scene } from '@farol/engine';
import { type FieldValue, type MaterialMapName, materialMapNames, materialMaps } from '@farol/engine/fields';
import {
  BoxGeometry,
  DataTexture,
  type Mesh,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  type Object3D,
  type Texture,
} from 'three';
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import { exportInTest, PageFileReader } from './testing/exportInTest';
import { PageCanvas, PageImageData, type Pixels, readPicture } from './testing/PageCanvas';

beforeAll(() => {
  vi.stubGlobal('FileReader', PageFileReader);
  vi.stubGlobal('OffscreenCanvas', PageCanvas);
  vi.stubGlobal('document', { createElement: () => new PageCanvas() });
  vi.stubGlobal('ImageData', PageImageData);
  vi.stubGlobal('createImageBitmap', readPicture);
  vi.stubGlobal('self', globalThis);
});
afterAll(() => void vi.unstubAllGlobals());

type Values = Readonly<Record<string, FieldValue>>;

/** Representation of a map in glTF: its used channels, and material values that the extension needs. */
interface Held {
  readonly channels: string;
  readonly needs?: Values;
}

/** Representation of each map of three's MeshPhysicalMaterial in glTF, or the reason why there is none. */
const table: Readonly<Record<string, Held | string>> = {
  map: { channels: 'rgba' },
  emissiveMap: { channels: 'rgb', needs: { emissive: [1, 1, 1] } },
  aoMap: { channels: 'r' },
  roughnessMap: { channels: 'g' },
  metalnessMap: { channels: 'b' },
  normalMap: { channels: 'rgb' },
  anisotropyMap: { channels: 'rgb', needs: { anisotropy: 1 } },
  clearcoatMap: { channels: 'r', needs: { clearcoat: 1 } },
  clearcoatRoughnessMap: { channels: 'g', needs: { clearcoat: 1 } },
  clearcoatNormalMap: { channels: 'rgb', needs: { clearcoat: 1 } },
  iridescenceMap: { channels: 'r', needs: { iridescence: 1 } },
  iridescenceThicknessMap: { channels: 'g', needs: { iridescence: 1 } },
  sheenColorMap: { channels: 'rgb', needs: { sheen: 1 } },
  sheenRoughnessMap: { channels: 'a', needs: { sheen: 1 } },
  specularIntensityMap: { channels: 'a', needs: { specularIntensity: 0.5 } },
  specularColorMap: { channels: 'rgb', needs: { specularIntensity: 0.5 } },
  transmissionMap: { channels: 'r', needs: { transmission: 1 } },
  thicknessMap: { channels: 'g', needs: { transmission: 1, thickness: 1 } },
  alphaMap: 'opacity is the alpha of the base colour',
  bumpMap: 'no extension of Khronos’',
  diffuseRoughnessMap: 'the extension is a proposal, and in no list of Khronos’',
  displacementMap: 'no extension of Khronos’',
  envMap: 'light of the surroundings, no part of a material',
  lightMap: 'no extension of Khronos’',
};

const held = Object.entries(table).filter((row): row is [string, Held] => typeof row[1] !== 'string');
const notHeld = Object.entries(table).flatMap(([property, row]) => (typeof row === 'string' ? [property] : []));

/** Field of a library material for a property of three's. */
const fieldOf = (property: string): MaterialMapName | undefined =>
  materialMapNames.find((name) => materialMaps[name].property === property);

/** UV placement whose values all differ from the defaults. */
const place: Values = {
  OffsetX: 0.25,
  OffsetY: 0.5,
  RepeatX: 2,
  RepeatY: 3,
  Rotation: 0.75,
  WrapX: 'mirror',
  Channel: 1,
};

const SIZE = 2;

/** A 2 by 2 image, different for each map and channel; every other one has its rows reversed. */
function pictureOf(property: string): DataTexture {
  const index = Object.keys(table).indexOf(property);
  const first = index * 8 + 3;
  const bytes = Uint8Array.from({ length: SIZE * SIZE * 4 }, (_, i) => (first + i * 11) % 255);
  const texture = new DataTexture(bytes, SIZE, SIZE);
  texture.flipY = index % 2 === 0;
  return texture;
}

interface Exported {
  readonly material: MeshPhysicalMaterial;
  readonly values: Values;
  readonly hasTangents: boolean;
  readonly leftOut: readonly string[];
}

/** A box with a library material that has these maps, exported as glTF, and imported again. */
async function exported(properties: readonly string[], values: Values = {}): Promise<Exported> {
  const scene = new Scene();
  const maps: Record<string, FieldValue> = {};
  for (const property of properties) {
    scene.assets.register(property, pictureOf(property));
    const field = fieldOf(property)!;
    maps[field] = property;
    for (const [ending, value] of Object.entries(place)) maps[field + ending] = value;
  }
  const box = new BoxGeometry();
  scene.assets.register('case', box.setAttribute('uv1', box.getAttribute('uv')));
  scene.assets.addMaterial('Gold', { kind: 'physical', ...maps, ...values });
  const object = new GameObject('Box');
  scene.add(object);
  object.addComponent(ObjectRenderer, { mesh: 'case', material: 'Gold' });
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const { blob, leftOut } = await exportInTest(scene);
  const isKnown = (message: unknown): boolean => String(message).includes('Merged metalnessMap and roughnessMap');
  expect(warn.mock.calls.flat().filter((message) => !isKnown(message))).toEqual([]);
  warn.mockRestore();
  scene.dispose();
  const assets = new AssetLibrary();
  assets.registerFile('box.glb', blob);
  await assets.load('box.glb');
  const model = assets.model('box.glb');
  const { materials } = objectsOfModel(model, assets, 'box.glb');
  const meshes: Mesh[] = [];
  model.scene.traverse((each: Object3D) => 'isMesh' in each && meshes.push(each as Mesh));
  const [{ material, geometry }] = meshes;
  return {
    material: material as MeshPhysicalMaterial,
    values: materials[0].values,
    hasTangents: 'tangent' in geometry.attributes,
    leftOut,
  };
}

/** Bytes of some channels, row of v = 0 first. */
function bytesOf({ image, flipY }: Texture, channels: string): number[] {
  const { data, width, height } = image as unknown as Pixels;
  const rows = Array.from({ length: height }, (_, row) => (flipY ? height - 1 - row : row));
  return rows
    .flatMap((row) =>
      Array.from({ length: width }, (_, x) =>
        [...channels].map((c) => data[(row * width + x) * 4 + 'rgba'.indexOf(c)]),
      ),
    )
    .flat();
}

function expectMap({ material, values }: Exported, property: string, { channels }: Held): void {
  const texture = (material as unknown as Record<string, Texture | null>)[property];
  expect(texture, property).not.toBeNull();
  const isNormals = property.toLowerCase().endsWith('normalmap');
  // the direction of green is tested below
  const compared = isNormals ? channels.replace('g', '') : channels;
  expect(bytesOf(texture!, compared), property).toEqual(bytesOf(pictureOf(property), compared));
  const field = fieldOf(property)!;
  for (const [ending, value] of Object.entries(place)) {
    const found = values[field + ending];
    if (typeof value === 'number') expect(found, field + ending).toBeCloseTo(value, 6);
    else expect(found, field + ending).toBe(value);
  }
  expect(values[field], field).toMatch(/^box\.glb\//);
}

test('the table has every map of three’s materials, and a library’s material has each but the surroundings', () => {
  const names = new Set<string>();
  for (const material of [new MeshStandardMaterial(), new MeshPhysicalMaterial()])
    for (const name in material) if (name === 'map' || name.endsWith('Map')) names.add(name);
  expect(Object.keys(table).toSorted()).toEqual([...names].toSorted());
  expect([...names].filter((property) => !fieldOf(property))).toEqual(['envMap']);
});

describe('glTF', () => {
  test.each(held)('holds %s', async (property, row) => {
    const found = await exported([property], row.needs);
    expectMap(found, property, row);
    expect(found.leftOut.join()).not.toContain('Maps');
  });

  test('holds all of them at once, each its own', async () => {
    const needs: Values = Object.assign({}, ...held.map(([, row]) => row.needs));
    const found = await exported(
      held.map(([property]) => property),
      needs,
    );
    expect(held.length).toBeGreaterThan(10);
    for (const [property, row] of held) expectMap(found, property, row);
  });

  test.each(notHeld.filter(fieldOf))('does not hold %s, and says so', async (property) => {
    const { material, leftOut } = await exported([property], { transparent: true, diffuseRoughness: 1 });
    expect(material).toMatchObject({ map: null });
    expect((material as unknown as Record<string, Texture | null | undefined>)[property] ?? null).toBeNull();
    expect(leftOut).toContain('Maps that glTF does not have are left out (1)');
  });

  test.each([
    ['normalMap', 'normal'],
    ['clearcoatNormalMap', 'clearcoatNormal'],
  ] as const)('holds which way %s points, and how far', async (property, prefix) => {
    for (const scale of [1, 0.5, -0.5]) {
      for (const flip of [false, true]) {
        const needs = { clearcoat: 1, [`${prefix}Scale`]: scale, [`${prefix}Flip`]: flip };
        const { material, hasTangents } = await exported([property], needs);
        const { x, y } = material[`${prefix}Scale`];
        expect([Math.abs(x), Math.abs(y)]).toEqual([Math.abs(scale), Math.abs(scale)]);
        const turned = (isTurned: boolean, bytes: number[]): number[] =>
          isTurned ? bytes.map((byte) => 255 - byte) : bytes;
        const texture = material[property]!;
        const message = `scale ${scale}, ${flip ? 'flipped' : 'as it is'}`;
        expect(turned(x < 0, bytesOf(texture, 'r')), message).toEqual(
          turned(scale < 0, bytesOf(pictureOf(property), 'r')),
        );
        // with tangents green is against v, without tangents along v
        expect(turned(y < 0 !== hasTangents, bytesOf(texture, 'g')), message).toEqual(
          turned(scale < 0 !== flip, bytesOf(pictureOf(property), 'g')),
        );
      }
    }
  });
});
