/** PlayCanvas's clustered lights on WebGL 2. */
import * as pc from 'playcanvas';
import type {
  RivalDrawing,
  RivalGeometry,
  RivalInstances,
  RivalPlacement,
  RivalPoints,
  RivalScene,
} from '../../../src/competitors/rivals/RivalScene';
import { agreeWithThree } from './chunks';
import { countDropped } from './countDropped';
import { fitCells, lightBoxes, mostLightsPerCell } from './fitCells';
import { encode, Materials } from './makeMaterials';

export const version = pc.version;

/** Number of lights that can be added before the grid of cells is fitted again. */
const spareLights = 32;

/** Ambient and hemisphere lights as irradiance in two bands of spherical harmonics, which represent them exactly. */
function ambientHarmonics({ ambient, hemispheres }: RivalScene): Float32Array | null {
  if (hemispheres.length === 0) return null;
  const bands = new Float32Array(27);
  for (let c = 0; c < 3; c++) {
    bands[c] = ambient[c];
    for (const { sky, ground, up } of hemispheres) {
      bands[c] += (sky[c] + ground[c]) / 2;
      for (let axis = 0; axis < 3; axis++) bands[3 * (1 + axis) + c] += (up[axis] * (sky[c] - ground[c])) / 2;
    }
  }
  return bands.map((value) => value / Math.PI);
}

function makeMesh(device: pc.GraphicsDevice, from: RivalGeometry): pc.Mesh {
  const mesh = new pc.Mesh(device);
  mesh.setPositions(from.positions);
  mesh.setNormals(from.normals);
  if (from.uvs) mesh.setUvs(0, from.uvs);
  if (from.colours) mesh.setColors(from.colours);
  mesh.setIndices(from.indices);
  mesh.update();
  return mesh;
}

interface InstanceBuffer {
  readonly buffer: pc.VertexBuffer;
  /** Contents of `buffer`: [matrix, colour] of each instance. */
  readonly floats: Float32Array;
}

function writeInstances({ buffer, floats }: InstanceBuffer, { matrices, colours }: RivalInstances): void {
  const stride = colours ? 19 : 16;
  for (let i = 0; i < buffer.getNumVertices(); i++) {
    for (let k = 0; k < 16; k++) floats[i * stride + k] = matrices[i * 16 + k];
    if (colours) for (let k = 0; k < 3; k++) floats[i * stride + 16 + k] = colours[i * 3 + k];
  }
  buffer.unlock();
}

function instanceBuffer(device: pc.GraphicsDevice, count: number, hasColours: boolean): InstanceBuffer {
  const semantics = [pc.SEMANTIC_ATTR11, pc.SEMANTIC_ATTR12, pc.SEMANTIC_ATTR14, pc.SEMANTIC_ATTR15];
  const lines = semantics.map((semantic) => ({ semantic, components: 4, type: pc.TYPE_FLOAT32 }));
  const colour = { semantic: pc.SEMANTIC_ATTR10, components: 3, type: pc.TYPE_FLOAT32 };
  const format = new pc.VertexFormat(device, hasColours ? [...lines, colour] : lines);
  const buffer = new pc.VertexBuffer(device, format, count, { usage: pc.BUFFER_DYNAMIC });
  return { buffer, floats: new Float32Array(buffer.lock() as ArrayBuffer) };
}

/** Sets the world placement of an object without a parent. */
function place(node: pc.Entity, p: RivalPlacement): void {
  node.setLocalPosition(p[0], p[1], p[2]);
  node.setLocalRotation(p[3], p[4], p[5], p[6]);
  node.setLocalScale(p[7], p[8], p[9]);
}

class PlayCanvasDrawing implements RivalDrawing {
  readonly gl: WebGL2RenderingContext;
  private readonly app: pc.AppBase;
  private readonly device: pc.WebglGraphicsDevice;
  private readonly camera: pc.Entity;
  private readonly lights: pc.Entity[] = [];
  private readonly nodes: pc.Entity[] = [];
  /** Maximum number of lights that the grid of cells was made for. */
  private room = 0;
  private readonly instances = new Map<number, InstanceBuffer>();

  constructor(
    canvas: HTMLCanvasElement,
    private readonly scene: RivalScene,
  ) {
    const { width, height } = scene;
    const device = new pc.WebglGraphicsDevice(canvas, { antialias: false, powerPreference: 'high-performance' });
    this.device = device;
    this.gl = device.gl;
    const options = new pc.AppOptions();
    options.graphicsDevice = device;
    options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem];
    this.app = new pc.AppBase(canvas);
    this.app.init(options);
    this.app.setCanvasFillMode(pc.FILLMODE_NONE, width, height);
    this.app.setCanvasResolution(pc.RESOLUTION_FIXED, width, height);
    agreeWithThree(device);
    const { lighting } = this.app.scene;
    this.app.scene.clusteredLightingEnabled = true;
    lighting.shadowsEnabled = false;
    lighting.cookiesEnabled = false;
    lighting.areaLightsEnabled = false;
    this.app.scene.ambientLight = encode(scene.ambient, 1 / Math.PI);
    this.camera = this.addCamera();
    // before the timed part: fitting the grid is the Lab's work, not part of PlayCanvas's first frame
    this.fitLighting(scene.points);
  }

  async drawFirst(): Promise<void> {
    this.addMeshes();
    this.addStillLights();
    this.setLights(this.scene.points);
    this.render();
  }

  render(): void {
    this.app.update(1 / 60);
    this.app.render();
  }

  moveLights({ count, positions }: RivalPoints): void {
    for (let i = 0; i < count; i++) {
      this.lights[i].setPosition(positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]);
    }
  }

  setLights(points: RivalPoints): void {
    const { lights } = this;
    while (lights.length > points.count) lights.pop()!.destroy();
    for (let i = lights.length; i < points.count; i++) {
      const [r, g, b] = points.colours.subarray(i * 3, i * 3 + 3);
      const light = new pc.Entity();
      light.addComponent('light', {
        type: 'omni',
        color: encode([r, g, b], 1 / Math.PI),
        intensity: 1,
        range: points.ranges[i],
        falloffMode: pc.LIGHTFALLOFF_INVERSESQUARED,
        castShadows: false,
      });
      lights.push(light);
      this.app.root.addChild(light);
    }
    this.moveLights(points);
    this.fitLighting(points);
  }

  moveCamera(): void {
    place(this.camera, this.scene.camera.placement);
  }

  moveMesh(mesh: number): void {
    place(this.nodes[mesh], this.scene.meshes[mesh].placement);
  }

  moveInstances(mesh: number): void {
    const { instances } = this.scene.meshes[mesh];
    const buffer = this.instances.get(mesh);
    if (instances && buffer) writeInstances(buffer, instances);
  }

  dropped(): number {
    return countDropped(this.app);
  }

  dispose(): void {
    this.app.destroy();
  }

  /** Fits the grid of cells to the lights, unless it has space for them already. */
  private fitLighting(points: RivalPoints): void {
    const { lighting } = this.app.scene;
    const { spots } = this.scene;
    const count = points.count + spots.length;
    if (count <= this.room) return;
    const { size, fullest } = fitCells(lightBoxes({ points, spots }));
    this.room = count + spareLights;
    lighting.cells = new pc.Vec3(...size);
    lighting.maxLights = this.room;
    lighting.maxLightsPerCell = Math.min(mostLightsPerCell, Math.ceil((fullest * 1.1 + 10) / 8) * 8);
  }

  private addCamera(): pc.Entity {
    const { camera, background } = this.scene;
    const entity = new pc.Entity();
    entity.addComponent('camera', {
      clearColor: background ? new pc.Color(...background) : new pc.Color(0, 0, 0, 0),
      fov: (camera.fov * 180) / Math.PI,
      nearClip: camera.near,
      farClip: camera.far,
      toneMapping: pc.TONEMAP_NONE,
      gammaCorrection: pc.GAMMA_SRGB,
    });
    this.app.root.addChild(entity);
    place(entity, camera.placement);
    return entity;
  }

  private addMeshes(): void {
    const { device, scene, app } = this;
    const materials = new Materials(device, scene, ambientHarmonics(scene));
    const meshes = scene.geometries.map((geometry) => makeMesh(device, geometry));
    const root = new pc.Entity();
    scene.meshes.forEach(({ geometry, material, placement, instances }, i) => {
      const hasColours = Boolean(instances?.colours);
      const node = new pc.Entity();
      place(node, placement);
      this.nodes.push(node);
      const meshInstance = new pc.MeshInstance(meshes[geometry], materials.get(material, hasColours));
      meshInstance.drawOrder = i;
      if (instances) {
        const made = instanceBuffer(device, instances.count, hasColours);
        writeInstances(made, instances);
        meshInstance.setInstancing(made.buffer);
        this.instances.set(i, made);
      }
      node.addComponent('render', { meshInstances: [meshInstance], castShadows: false, receiveShadows: false });
      root.addChild(node);
    });
    app.root.addChild(root);
    const world = app.scene.layers.getLayerById(pc.LAYERID_WORLD);
    if (scene.isOrdered && world) world.opaqueSortMode = pc.SORTMODE_MANUAL;
  }

  private addStillLights(): void {
    const add = (options: object, direction: readonly [number, number, number]): pc.Entity => {
      const light = new pc.Entity();
      light.addComponent('light', { intensity: 1, castShadows: false, ...options });
      light.setRotation(new pc.Quat().setFromDirections(pc.Vec3.DOWN, new pc.Vec3(...direction)));
      this.app.root.addChild(light);
      return light;
    };
    for (const { colour, direction } of this.scene.directionals) {
      add({ type: 'directional', color: encode(colour, 1 / Math.PI) }, direction);
    }
    for (const { colour, direction, position, range, angle, innerAngle } of this.scene.spots) {
      const light = add(
        {
          type: 'spot',
          color: encode(colour, 1 / Math.PI),
          range,
          falloffMode: pc.LIGHTFALLOFF_INVERSESQUARED,
          innerConeAngle: (innerAngle * 180) / Math.PI,
          outerConeAngle: (angle * 180) / Math.PI,
        },
        direction,
      );
      light.setPosition(...position);
    }
  }
}

/** Opens PlayCanvas for a scene. @throws Error naming the unsupported feature */
export const open = (canvas: HTMLCanvasElement, scene: RivalScene): RivalDrawing =>
  new PlayCanvasDrawing(canvas, scene);
