/** Babylon.js's ClusteredLightContainer on WebGL 2. */
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { ClusteredLightContainer } from '@babylonjs/core/Lights/Clustered/clusteredLightContainer.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { PointLight } from '@babylonjs/core/Lights/pointLight.js';
import { SpotLight } from '@babylonjs/core/Lights/spotLight.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Geometry } from '@babylonjs/core/Meshes/geometry.js';
import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js';
import '@babylonjs/core/Meshes/thinInstanceMesh.js';
import { Logger } from '@babylonjs/core/Misc/logger.js';
import { Scene } from '@babylonjs/core/scene.js';
import type { Nullable } from '@babylonjs/core/types.js';
import type {
  RivalDrawing,
  RivalGeometry,
  RivalPlacement,
  RivalPoints,
  RivalScene,
  Rgb,
} from '../../../src/competitors/rivals/RivalScene';
import { agreeWithThree } from './agreeWithThree';
import { makeMaterials } from './makeMaterials';

export const version = Engine.Version;

const colour = ([r, g, b]: Rgb, scale = 1): Color3 => new Color3(r * scale, g * scale, b * scale);

function makeGeometry(scene: Scene, from: RivalGeometry, name: string): Geometry {
  const data = new VertexData();
  data.positions = from.positions;
  data.normals = from.normals;
  if (from.uvs) data.uvs = from.uvs;
  if (from.colours) data.colors = from.colours;
  data.indices = from.indices;
  return new Geometry(name, scene, data);
}

/** Colours of instances with an alpha of 1 added, which Babylon needs. */
function withOpacity(colours: Float32Array): Float32Array {
  const result = new Float32Array((colours.length / 3) * 4).fill(1);
  for (let i = 0; i < colours.length / 3; i++) result.set(colours.subarray(i * 3, i * 3 + 3), i * 4);
  return result;
}

/** Sets the world position and rotation of an object without a parent. */
function place(object: { position: Vector3; rotationQuaternion: Nullable<Quaternion> }, p: RivalPlacement): void {
  object.position.set(p[0], p[1], p[2]);
  object.rotationQuaternion?.set(p[3], p[4], p[5], p[6]);
}

/** Sets the world placement of a mesh and freezes it. */
function placeMesh(mesh: Mesh, placement: RivalPlacement): void {
  mesh.unfreezeWorldMatrix();
  mesh.rotationQuaternion ??= new Quaternion();
  place(mesh, placement);
  mesh.scaling.set(placement[7], placement[8], placement[9]);
  mesh.freezeWorldMatrix();
}

class BabylonDrawing implements RivalDrawing {
  readonly gl: WebGL2RenderingContext;
  private readonly engine: Engine;
  private readonly scene: Scene;
  private readonly container: ClusteredLightContainer;
  private readonly lights: PointLight[] = [];
  private readonly camera: FreeCamera;
  private meshes: Mesh[] = [];

  constructor(
    canvas: HTMLCanvasElement,
    private readonly from: RivalScene,
    private readonly signal: AbortSignal,
  ) {
    // disables the banner in the console
    Logger.LogLevels = Logger.WarningLogLevel | Logger.ErrorLogLevel;
    this.engine = new Engine(
      canvas,
      false,
      { useExactSrgbConversions: true, powerPreference: 'high-performance', audioEngine: false },
      false,
    );
    agreeWithThree();
    this.gl = this.engine._gl;
    this.scene = new Scene(this.engine);
    this.scene.useRightHandedSystem = true;
    this.scene.detachControl();
    const { background, ambient, points, spots } = from;
    this.scene.clearColor = background ? new Color4(...background, 1) : new Color4(0, 0, 0, 0);
    this.scene.ambientColor = colour(ambient, 1 / Math.PI);
    this.container = new ClusteredLightContainer('lights', [], this.scene);
    if (!this.container.isSupported) {
      this.engine.dispose();
      throw new Error('Babylon.js clusters no lights here: it needs to blend into 32-bit float targets.');
    }
    this.container.maxRange = Math.max(...points.ranges, ...spots.map(({ range }) => range), 1e-3);
    this.camera = this.addCamera();
  }

  async drawFirst(): Promise<void> {
    this.meshes = this.addMeshes();
    this.addStillLights();
    this.setLights(this.from.points);
    // Babylon compiles shaders in parallel
    while (!this.scene.isReady(true)) {
      await new Promise((resolve) => setTimeout(resolve));
      this.signal.throwIfAborted();
    }
    this.render();
  }

  render(): void {
    this.engine.beginFrame();
    this.scene.render();
    this.engine.endFrame();
  }

  moveLights({ count, positions }: RivalPoints): void {
    for (let i = 0; i < count; i++) {
      this.lights[i].position.set(positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]);
    }
  }

  setLights(points: RivalPoints): void {
    const { lights, container, scene } = this;
    while (lights.length > points.count) {
      const light = lights.pop()!;
      container.removeLight(light);
      light.dispose();
    }
    for (let i = lights.length; i < points.count; i++) {
      const light = new PointLight(`light ${i}`, new Vector3(), scene, true);
      const [r, g, b] = points.colours.subarray(i * 3, i * 3 + 3);
      light.diffuse = light.specular = colour([r, g, b]);
      light.range = points.ranges[i];
      lights.push(light);
      container.addLight(light);
    }
    this.moveLights(points);
  }

  moveCamera(): void {
    place(this.camera, this.from.camera.placement);
  }

  moveMesh(mesh: number): void {
    placeMesh(this.meshes[mesh], this.from.meshes[mesh].placement);
  }

  moveInstances(mesh: number): void {
    this.meshes[mesh].thinInstanceBufferUpdated('matrix');
  }

  dropped(): number {
    // no cluster drops lights: the container's masks have a bit for each one
    return 0;
  }

  dispose(): void {
    this.engine.dispose();
  }

  private addCamera(): FreeCamera {
    const { fov, near, far, placement } = this.from.camera;
    const camera = new FreeCamera('camera', new Vector3(), this.scene);
    camera.fov = fov;
    camera.minZ = near;
    camera.maxZ = far;
    camera.rotationQuaternion = new Quaternion();
    camera.inputs.clear();
    place(camera, placement);
    return camera;
  }

  private addMeshes(): Mesh[] {
    const { from, scene } = this;
    // the container counts as one light in a material's limit
    const lights = from.directionals.length + from.hemispheres.length + 1;
    const materials = makeMaterials(scene, from, lights);
    const geometries = from.geometries.map((geometry, i) => makeGeometry(scene, geometry, `geometry ${i}`));
    return from.meshes.map(({ geometry, material, placement, instances }, i) => {
      const mesh = new Mesh(`mesh ${i}`, scene);
      // instance buffers belong to a geometry, so that instanced meshes need one of their own
      const own = instances ? makeGeometry(scene, from.geometries[geometry], `geometry of mesh ${i}`) : null;
      (own ?? geometries[geometry]).applyToMesh(mesh);
      mesh.material = materials[material];
      mesh.useVertexColors = from.materials[material].hasVertexColours || Boolean(instances?.colours);
      mesh.hasVertexAlpha = false;
      placeMesh(mesh, placement);
      if (instances) {
        const { matrices, colours, count } = instances;
        mesh.thinInstanceSetBuffer('matrix', matrices.subarray(0, count * 16), 16, false);
        if (colours) mesh.thinInstanceSetBuffer('color', withOpacity(colours), 4, true);
      }
      return mesh;
    });
  }

  private addStillLights(): void {
    const { scene, container, from } = this;
    for (const { sky, ground, up } of from.hemispheres) {
      const light = new HemisphericLight('hemisphere', new Vector3(...up), scene);
      // Babylon's hemispheric light is radiance, three's irradiance
      light.diffuse = colour(sky, 1 / Math.PI);
      light.groundColor = colour(ground, 1 / Math.PI);
      light.specular = new Color3(0, 0, 0);
    }
    for (const { colour: of, direction } of from.directionals) {
      const light = new DirectionalLight('directional', new Vector3(...direction), scene);
      light.diffuse = light.specular = colour(of);
    }
    for (const { colour: of, position, direction, range, angle, innerAngle } of from.spots) {
      const light = new SpotLight(
        'spot',
        new Vector3(...position),
        new Vector3(...direction),
        angle * 2,
        1,
        scene,
        true,
      );
      light.innerAngle = innerAngle * 2;
      light.diffuse = light.specular = colour(of);
      light.range = range;
      container.addLight(light);
    }
  }
}

/** Opens Babylon.js for a scene. @throws Error naming the unsupported feature */
export const open = (canvas: HTMLCanvasElement, scene: RivalScene, signal: AbortSignal): RivalDrawing =>
  new BabylonDrawing(canvas, scene, signal);
