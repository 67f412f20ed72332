import {
  AddEquation,
  BackSide,
  CustomBlending,
  FrontSide,
  GreaterEqualDepth,
  InstancedBufferGeometry,
  Mesh,
  OneFactor,
  Vector4,
  type IUniform,
} from 'three';
import { isCountView } from '../../frame/views';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { PassMaterial } from '../../gpu/PassMaterial';

/** Number of vertices in lightVolumeSphere.glsl: 12 segments × 8 rings × 6 vertices a quad. */
const SPHERE_VERTICES = 576;
/** Number of vertices in lightVolumeField.glsl: an icosahedron of 20 triangles. */
const FIELD_VERTICES = 60;
/** Number of vertices in lightVolumeCone.glsl: 12 segments of a side and a cap, 3 vertices each. */
const CONE_VERTICES = 72;

const ADDITIVE = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
} as const;
/** Geometries shared by all renderers of the page; `instanceCount` is set before each draw. */
const sphereGeometry = /* @__PURE__ */ vertexless(SPHERE_VERTICES);
const coneGeometry = /* @__PURE__ */ vertexless(CONE_VERTICES);
const fieldGeometry = /* @__PURE__ */ vertexless(FIELD_VERTICES);

/**
 * Render state that draws a volume's back faces where they lie behind the surface: works with the camera inside the volume, and
 * skips volumes in front of the surface.
 */
const VOLUME = { ...ADDITIVE, side: BackSide, depthTest: true, depthFunc: GreaterEqualDepth } as const;

interface Materials {
  readonly global: FullscreenPass;
  readonly sphere: PassMaterial;
  readonly cone: PassMaterial;
  /** Material for lights of light fields; null until needed. */
  field: PassMaterial | null;
  readonly makeField: () => PassMaterial;
}

/**
 * Draws each light over the pixels of its volume, added to what the bound target holds: a triangle over the whole picture for
 * directional and unbounded lights, instanced spheres for point lights, cones for spot lights. Needs the scene's depth in the
 * target, and the light order 'by-volume'.
 * @see Hargreaves and Harris 2004, Deferred Shading
 */
export class LightVolumeDraws {
  private readonly firstRecord = { value: 0 };
  private readonly spheres = instanced(sphereGeometry);
  private readonly cones = instanced(coneGeometry);
  private readonly fields = instanced(fieldGeometry);
  private shading: Materials | null = null;
  private counting: Materials | null = null;

  /**
   * @param label - prefix of the programs' names, with a space at its end
   * @param target - microshader that reads a pixel's surface, lights it and writes the result: defines FarolPixel and the
   *   functions of volumeLighting.glsl
   * @param uniforms - uniforms of that microshader
   */
  constructor(
    private readonly label: string,
    private readonly target: string,
    private readonly uniforms: Record<string, IUniform>,
  ) {}

  /** Draws all lights of the frame; in heat-map views adds 1 for each light instead. */
  draw(frame: Frame): void {
    const { lights } = frame;
    const materials = isCountView(frame.view)
      ? (this.counting ??= this.make(frame, true))
      : (this.shading ??= this.make(frame, false));
    // volumes have linear depth: where the scene's depth is logarithmic or too coarse, only the range limits the light
    const depthTest = !frame.webgl.capabilities.logarithmicDepthBuffer && !frame.storesDistance;
    materials.sphere.depthTest = materials.cone.depthTest = depthTest;
    // a mirroring projection swaps front and back faces
    const { elements: p } = frame.camera.projectionMatrix;
    const side = p[0] * p[5] < 0 ? FrontSide : BackSide;
    materials.sphere.side = materials.cone.side = side;
    if (lights.directional + lights.unbounded > 0) materials.global.draw(frame);
    if (lights.sphereCount > 0) {
      this.firstRecord.value = lights.firstBounded;
      this.spheres.geometry.instanceCount = lights.sphereCount;
      frame.drawMesh(this.spheres, materials.sphere);
    }
    if (lights.slots > 0) {
      const field = (materials.field ??= materials.makeField());
      field.depthTest = depthTest;
      field.side = side;
      this.firstRecord.value = lights.firstSlot;
      this.fields.geometry.instanceCount = lights.slots;
      frame.drawMesh(this.fields, field);
    }
    if (lights.coneCount > 0) {
      this.firstRecord.value = lights.firstBounded + lights.sphereCount;
      this.cones.geometry.instanceCount = lights.coneCount;
      frame.drawMesh(this.cones, materials.cone);
    }
  }

  dispose(): void {
    for (const materials of [this.shading, this.counting]) {
      materials?.global.dispose();
      materials?.sphere.dispose();
      materials?.cone.dispose();
      materials?.field?.dispose();
    }
    this.shading = this.counting = null;
  }

  private make(frame: Frame, count: boolean): Materials {
    const uniforms = {
      farol_fit: { value: new Vector4(1, 1, 0, 0) },
      ...this.uniforms,
      farol_firstRecord: this.firstRecord,
      dfgLUT: { value: null },
    };
    const defines: Record<string, string> = count ? { FAROL_COUNT: '' } : {};
    const volume = (name: string, vertex: string) =>
      new PassMaterial(frame.microshaders, {
        name: `Farol ${this.label}${name}`,
        vertex: [vertex],
        fragment: [this.target, 'lightVolumeFragment'],
        uniforms: { ...frame.uniforms, ...uniforms },
        defines,
        ...VOLUME,
      });
    const materials = {
      global: new FullscreenPass({
        program: `${this.label}global lights`,
        fragment: [this.target, 'globalLightsFragment'],
        shared: 'all',
        uniforms,
        defines,
        ...ADDITIVE,
      }),
      sphere: volume('light spheres', 'lightVolumeSphere'),
      cone: volume('light cones', 'lightVolumeCone'),
      field: null,
      makeField: () => volume('lights of fields', 'lightVolumeField'),
    };
    // compiled ahead, so that the first light of each kind does not wait for its program
    materials.global.compile(frame);
    frame.compileMesh(this.spheres, materials.sphere);
    frame.compileMesh(this.cones, materials.cone);
    return materials;
  }
}

function vertexless(vertices: number): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setDrawRange(0, vertices);
  geometry.instanceCount = 0;
  return geometry;
}

function instanced(geometry: InstancedBufferGeometry): Mesh<InstancedBufferGeometry> {
  const mesh = new Mesh(geometry);
  mesh.frustumCulled = false;
  return mesh;
}
