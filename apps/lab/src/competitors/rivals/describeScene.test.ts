import {
  AmbientLight,
  BoxGeometry,
  BufferAttribute,
  Color,
  DataTexture,
  DirectionalLight,
  Fog,
  HemisphereLight,
  InstancedMesh,
  LinearFilter,
  LinearMipmapLinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MirroredRepeatWrapping,
  Object3D,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Points,
  RepeatWrapping,
  Scene,
  SpotLight,
  SRGBColorSpace,
} from 'three';
import { describe, expect, it } from 'vitest';
import type { StageScene } from '../../stage/StageScene';
import { describeScene } from './describeScene';
import type { RivalScene } from './RivalScene';

interface Parts {
  readonly meshes?: readonly Object3D[];
  readonly lights?: readonly PointLight[];
  readonly still?: readonly (AmbientLight | HemisphereLight | DirectionalLight | SpotLight)[];
}

function stageOf({ meshes = [], lights = [], still = [] }: Parts): StageScene {
  const three = new Scene();
  for (const object of [...meshes, ...lights, ...still]) three.add(object);
  const camera = new PerspectiveCamera(50, 16 / 9, 0.5, 80);
  camera.position.set(0, 2, 5);
  const parts = { three, camera, lights, still, width: 320, height: 180, setTime() {}, addLights: () => () => {} };
  return { ...parts, kind: 'points', shading: 'own', emitter: null };
}

const described = (parts: Parts): RivalScene => describeScene(stageOf(parts)).scene;

const box = (values: ConstructorParameters<typeof MeshStandardMaterial>[0] = {}): Mesh =>
  new Mesh(new BoxGeometry(), new MeshStandardMaterial(values));

/** 2 × 2 texels, the row at v = 0 first. */
function texture(): DataTexture {
  const result = new DataTexture(
    Uint8Array.from({ length: 16 }, (_, i) => i),
    2,
    2,
  );
  result.colorSpace = SRGBColorSpace;
  result.wrapS = RepeatWrapping;
  result.wrapT = MirroredRepeatWrapping;
  result.magFilter = LinearFilter;
  result.minFilter = LinearMipmapLinearFilter;
  result.needsUpdate = true;
  return result;
}

const close = (values: Iterable<number>): number[] => [...values].map((value) => Math.round(value * 1e5) / 1e5 + 0);

describe('a scene for another engine', () => {
  it('has the camera, the size and the background in sRGB', () => {
    const stage = stageOf({});
    stage.three.background = new Color(0.2, 0.5, 1);
    const { camera, background, width, height } = describeScene(stage).scene;
    expect([width, height]).toEqual([320, 180]);
    expect(camera.fov).toBeCloseTo((50 * Math.PI) / 180, 10);
    expect([camera.near, camera.far]).toEqual([0.5, 80]);
    expect([...camera.placement]).toEqual([0, 2, 5, 0, 0, 0, 1, 1, 1, 1]);
    expect(close(background!)).toEqual([0.48453, 0.73536, 1]);
  });

  it('has lights with colour times intensity, in the world', () => {
    const parent = new Object3D();
    parent.position.set(10, 0, 0);
    const point = new PointLight(new Color(1, 0.5, 0.25), 4, 7);
    point.position.set(1, 2, 3);
    parent.add(point);
    const spot = new SpotLight(new Color(1, 1, 1), 3, 9, 0.4, 0.25);
    spot.position.set(0, 5, 0);
    const sun = new DirectionalLight(new Color(1, 1, 0), 2);
    sun.position.set(0, 0, 4);
    const sky = new HemisphereLight(new Color(0, 0, 1), new Color(0, 1, 0), 0.5);
    sky.position.set(0, 3, 0);
    const ambient = [new AmbientLight(new Color(1, 0, 0), 0.25), new AmbientLight(new Color(1, 1, 0), 0.5)];
    const stage = stageOf({ still: [spot, sun, sky, ...ambient] });
    stage.three.add(parent);
    const scene = describeScene({ ...stage, lights: [point] }).scene;
    expect(scene.points.count).toBe(1);
    expect([...scene.points.colours]).toEqual([4, 2, 1]);
    expect([...scene.points.ranges]).toEqual([7]);
    expect([...scene.points.positions]).toEqual([11, 2, 3]);
    expect(scene.ambient).toEqual([0.75, 0.5, 0]);
    expect(scene.hemispheres).toEqual([{ sky: [0, 0, 0.5], ground: [0, 0.5, 0], up: [0, 1, 0] }]);
    expect(scene.directionals).toEqual([{ colour: [2, 2, 0], direction: [0, 0, -1] }]);
    expect(scene.spots).toHaveLength(1);
    expect(scene.spots[0]).toMatchObject({ colour: [3, 3, 3], position: [0, 5, 0], range: 9, angle: 0.4 });
    expect(scene.spots[0].innerAngle).toBeCloseTo(0.3, 10);
    expect(close(scene.spots[0].direction)).toEqual([0, -1, 0]);
  });

  it('shares geometries, materials and textures, and places meshes with mirrors', () => {
    const map = texture();
    const first = box({ map, normalMap: map });
    const second = new Mesh(first.geometry, first.material);
    second.position.set(1, 2, 3);
    second.scale.set(-2, 1, 1);
    const scene = described({ meshes: [first, second] });
    expect([scene.geometries.length, scene.materials.length, scene.textures.length]).toEqual([1, 1, 1]);
    expect(scene.meshes.map(({ geometry, material }) => [geometry, material])).toEqual([
      [0, 0],
      [0, 0],
    ]);
    expect(close(scene.meshes[1].placement)).toEqual([1, 2, 3, 0, 0, 0, 1, -2, 1, 1]);
    expect(scene.isOrdered).toBe(false);
    const { positions, indices, uvs } = scene.geometries[0];
    expect([positions.length, uvs?.length, indices.length]).toEqual([72, 48, 36]);
  });

  it('draws meshes in the order that the scene sets', () => {
    const meshes = [box(), box(), box()];
    meshes.forEach((mesh, i) => {
      mesh.position.x = i;
      mesh.renderOrder = -i;
    });
    const scene = described({ meshes });
    expect(scene.isOrdered).toBe(true);
    expect(scene.meshes.map(({ placement }) => placement[0])).toEqual([2, 1, 0]);
  });

  it('has textures as three sends them, and how a material uses them', () => {
    const map = texture();
    map.repeat.set(2, 3);
    map.offset.set(0.25, 0.5);
    const flipped = texture();
    flipped.flipY = true;
    const scene = described({ meshes: [box({ map, emissiveMap: flipped })] });
    const [plain, turned] = scene.textures;
    expect(plain).toMatchObject({ width: 2, height: 2, isSrgb: true, wrapU: 'repeat', wrapV: 'mirror' });
    expect(plain).toMatchObject({ mipmaps: 'linear', isMinLinear: true, isMagLinear: true, anisotropy: 1 });
    expect([...plain.pixels.slice(0, 4)]).toEqual([0, 1, 2, 3]);
    expect([...turned.pixels.slice(0, 4)]).toEqual([8, 9, 10, 11]);
    expect(scene.materials[0].map).toEqual({ texture: 0, scale: [2, 3], offset: [0.25, 0.5] });
    expect(scene.materials[0].emissiveMap?.texture).toBe(1);
  });

  it('has the numbers of materials', () => {
    const values = { roughness: 0.3, metalness: 0.9, emissive: new Color(0.5, 0, 0), emissiveIntensity: 3 };
    const glass = box({ ...values, transparent: true, opacity: 0.4 });
    const plain = new Mesh(new BoxGeometry(), new MeshBasicMaterial({ color: new Color(0, 1, 0), opacity: 0.4 }));
    const [lit, unlit] = described({ meshes: [glass, plain] }).materials;
    expect(lit).toMatchObject({ isLit: true, roughness: 0.3, metalness: 0.9, emissive: [1.5, 0, 0] });
    expect(lit).toMatchObject({ isTransparent: true, opacity: 0.4 });
    expect(unlit).toMatchObject({ isLit: false, colour: [0, 1, 0], isTransparent: false, opacity: 1 });
  });

  it('cuts a mesh of several materials into their parts', () => {
    const materials = Array.from({ length: 6 }, () => new MeshStandardMaterial());
    const scene = described({ meshes: [new Mesh(new BoxGeometry(), materials)] });
    expect(scene.meshes).toHaveLength(6);
    const whole = new BoxGeometry().index!.array;
    expect(scene.geometries.flatMap(({ indices }) => [...indices])).toEqual([...whole]);
  });

  it('gives flat shading a normal for each triangle, and vertices without colours opacity 1', () => {
    const bent = new PlaneGeometry(1, 1);
    (bent.attributes.position as BufferAttribute).setZ(0, 1);
    bent.setAttribute('color', new BufferAttribute(new Float32Array(12).fill(0.5), 3));
    const flat = new Mesh(bent, new MeshStandardMaterial({ flatShading: true, vertexColors: true }));
    const { normals, colours } = described({ meshes: [flat] }).geometries[0];
    expect(normals).toHaveLength(18);
    const corner = (i: number): number[] => close(normals.slice(i * 3, i * 3 + 3));
    expect(corner(0)).toEqual(corner(1));
    expect(corner(1)).toEqual(corner(2));
    expect(corner(3)).not.toEqual(corner(2));
    expect([...colours!.slice(0, 4)]).toEqual([0.5, 0.5, 0.5, 1]);
  });

  it('has instances with their colours', () => {
    const mesh = new InstancedMesh(new BoxGeometry(), new MeshStandardMaterial(), 2);
    mesh.setMatrixAt(1, new Matrix4().makeTranslation(4, 5, 6));
    mesh.setColorAt(1, new Color(1, 0, 0.5));
    const { instances } = described({ meshes: [mesh] }).meshes[0];
    expect(instances?.count).toBe(2);
    expect([...instances!.matrices.slice(28, 31)]).toEqual([4, 5, 6]);
    expect([...instances!.colours!.slice(3)]).toEqual([1, 0, 0.5]);
  });

  it('leaves out what is not seen', () => {
    const hidden = box();
    hidden.visible = false;
    const elsewhere = box();
    elsewhere.layers.set(3);
    const dark = new SpotLight(0xffffff, 1, 5);
    dark.visible = false;
    const scene = described({ meshes: [hidden, elsewhere], still: [dark] });
    expect([scene.meshes.length, scene.spots.length]).toEqual([0, 0]);
  });

  const sheared = box();
  sheared.matrixAutoUpdate = false;
  sheared.matrix.makeShear(0.5, 0, 0, 0, 0, 0);
  const odd = texture();
  odd.rotation = 1;
  const shadow = new PointLight(0xffffff, 1, 5);
  shadow.castShadow = true;
  it.each<[string, Parts, RegExp]>([
    [
      'a kind of material',
      { meshes: [new Mesh(new BoxGeometry(), new MeshPhongMaterial())] },
      /is a MeshPhongMaterial/,
    ],
    [
      'clearcoat',
      { meshes: [new Mesh(new BoxGeometry(), new MeshPhysicalMaterial({ clearcoat: 1 }))] },
      /has clearcoat/,
    ],
    ['a map', { meshes: [box({ aoMap: texture() })] }, /has an aoMap/],
    ['a texture that is turned', { meshes: [box({ map: odd })] }, /rotates a texture/],
    ['points', { meshes: [new Points()] }, /is a Points/],
    ['a sheared mesh', { meshes: [sheared] }, /is sheared/],
    ['a light without an end', { lights: [new PointLight()] }, /has no range/],
    ['another decay', { lights: [new PointLight(0xffffff, 1, 5, 1)] }, /decay 1/],
    ['shadows', { lights: [shadow] }, /casts shadows/],
  ])('refuses %s', (_, parts, why) => {
    expect(() => described(parts)).toThrow(why);
  });

  it('refuses fog, a background that is a texture, and a light that the stage does not name', () => {
    const foggy = stageOf({});
    foggy.three.fog = new Fog(0xffffff);
    expect(() => describeScene(foggy)).toThrow(/has fog/);
    const pictured = stageOf({});
    pictured.three.background = texture();
    expect(() => describeScene(pictured)).toThrow(/background is a texture/);
    const more = stageOf({});
    more.three.add(new PointLight(0xffffff, 1, 5));
    expect(() => describeScene(more)).toThrow(/cannot be given/);
  });

  it('refuses a material that changes three’s shaders, and takes copies of one that does not', () => {
    const changed = box();
    (changed.material as MeshStandardMaterial).onBeforeCompile = () => {};
    expect(() => described({ meshes: [changed] })).toThrow(/changes three’s shaders/);
    const copied = box();
    const { onBeforeCompile } = new MeshStandardMaterial();
    (copied.material as MeshStandardMaterial).onBeforeCompile = onBeforeCompile;
    expect(described({ meshes: [copied] }).materials).toHaveLength(1);
  });
});
