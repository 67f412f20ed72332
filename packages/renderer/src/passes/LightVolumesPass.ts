import {
  AddEquation,
  BackSide,
  CustomBlending,
  DepthTexture,
  FloatType,
  GreaterEqualDepth,
  HalfFloatType,
  InstancedBufferGeometry,
  Mesh,
  NearestFilter,
  OneFactor,
  WebGLRenderTarget,
} from 'three';
import { isCountView } from '../debug/views';
import type { Frame } from '../Frame';
import type { GBuffer } from '../gbuffer/GBuffer';
import { FullscreenMesh } from './FullscreenMesh';
import type { GBufferPass } from './GBufferPass';
import { gbufferUniforms, setGBufferUniforms } from './gbufferUniforms';
import type { Pass } from './Pass';
import { PassMaterial, type PassMaterialOptions } from './PassMaterial';

/** 12 segments, 8 rings, 6 vertices a quad; the same numbers as in lightVolumeSphere.glsl. */
const SPHERE_VERTICES = 576;
/** 12 segments of a side and a cap, 3 vertices each. */
const CONE_VERTICES = 72;

const ADDITIVE = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
} as const;
/** Back faces behind the surface: right with the camera inside the volume, and nothing to do where the volume floats before it. */
const VOLUME = { ...ADDITIVE, side: BackSide, depthTest: true, depthFunc: GreaterEqualDepth } as const;

function instanced(vertices: number): Mesh<InstancedBufferGeometry> {
  const geometry = new InstancedBufferGeometry();
  geometry.setDrawRange(0, vertices);
  geometry.instanceCount = 0;
  const mesh = new Mesh(geometry);
  mesh.frustumCulled = false;
  return mesh;
}

interface Materials {
  readonly global: PassMaterial;
  readonly sphere: PassMaterial;
  readonly cone: PassMaterial;
}

/**
 * Adds up the light of every pixel of the G-buffer, each light over the pixels of its volume: a triangle over the whole
 * picture for directional and unbounded lights, instanced spheres for point lights, cones for spot lights.
 */
export class LightVolumesPass implements Pass {
  readonly name = 'light volumes';
  readonly reads = ['gbuffer'] as const;
  readonly writes = ['lighting'] as const;
  /** Sum of the light, and a copy of the scene's depth, since the depth texture itself is read meanwhile. */
  target: WebGLRenderTarget | null = null;
  private readonly uniforms = gbufferUniforms();
  private readonly firstRecord = { value: 0 };
  private readonly triangle = new FullscreenMesh();
  private readonly spheres = instanced(SPHERE_VERTICES);
  private readonly cones = instanced(CONE_VERTICES);
  private shading: Materials | null = null;
  private counting: Materials | null = null;

  constructor(private readonly source: GBufferPass) {}

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * 12 : 0;
  }

  render(frame: Frame): void {
    const gbuffer = this.source.gbuffer!;
    this.prepareTarget(frame, gbuffer);
    setGBufferUniforms(this.uniforms, gbuffer, frame);
    const { lights } = frame;
    const materials = isCountView(frame.view)
      ? (this.counting ??= this.make(frame, true))
      : (this.shading ??= this.make(frame, false));
    if (lights.directional + lights.unbounded > 0) frame.drawMesh(this.triangle, materials.global);
    if (lights.spheres > 0) {
      this.firstRecord.value = lights.firstBounded;
      this.spheres.geometry.instanceCount = lights.spheres;
      frame.drawMesh(this.spheres, materials.sphere);
    }
    if (lights.cones > 0) {
      this.firstRecord.value = lights.firstBounded + lights.spheres;
      this.cones.geometry.instanceCount = lights.cones;
      frame.drawMesh(this.cones, materials.cone);
    }
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
    for (const materials of [this.shading, this.counting]) {
      materials?.global.dispose();
      materials?.sphere.dispose();
      materials?.cone.dispose();
    }
    this.shading = this.counting = null;
  }

  private prepareTarget(frame: Frame, gbuffer: GBuffer): void {
    const { width, height } = frame;
    this.target ??= new WebGLRenderTarget(1, 1, {
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, FloatType),
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(1, false);
    frame.copyDepth(gbuffer.target, this.target);
  }

  private make(frame: Frame, count: boolean): Materials {
    const material = (name: string, vertex: string, fragment: string, state: Partial<PassMaterialOptions>) =>
      new PassMaterial(frame.microshaders, {
        name: `Farol ${name}`,
        vertex: [vertex],
        fragment: [fragment],
        uniforms: { ...frame.uniforms, ...this.uniforms, farol_firstRecord: this.firstRecord, dfgLUT: { value: null } },
        defines: count ? { FAROL_COUNT: '' } : {},
        ...state,
      });
    const materials = {
      global: material('global lights', 'fullscreen', 'globalLightsFragment', ADDITIVE),
      sphere: material('light spheres', 'lightVolumeSphere', 'lightVolumeFragment', VOLUME),
      cone: material('light cones', 'lightVolumeCone', 'lightVolumeFragment', VOLUME),
    };
    // a kind of light that comes later finds its program
    frame.compileMesh(this.triangle, materials.global);
    frame.compileMesh(this.spheres, materials.sphere);
    frame.compileMesh(this.cones, materials.cone);
    return materials;
  }
}
