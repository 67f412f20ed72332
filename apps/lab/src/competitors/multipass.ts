import {
  AddEquation,
  CustomBlending,
  HalfFloatType,
  InstancedMesh,
  LessEqualDepth,
  type Material,
  Mesh,
  MeshBasicMaterial,
  NearestFilter,
  OneFactor,
  OrthographicCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SrcAlphaFactor,
  WebGLRenderTarget,
} from 'three';
import { webglProblem } from '../stage/deviceLimits';
import type { StageScene } from '../stage/StageScene';
import type { Competitor, Drawing } from './Competitor';
import { competitorNames } from './competitorNames';
import { createWebGL } from './createWebGL';
import { lackingInThree, pointsAlone, refuseMatter } from './refuseMatter';

/**
 * The thesis's forward rendering, with three's renderer: a base pass with all lights except the moving ones, then the
 * whole scene again for each moving light, added in linear half floats.
 */
export const multipass: Competitor = {
  name: 'multipass',
  ...competitorNames.multipass,
  unavailable: async () => webglProblem(),
  refuses: (scene) => refuseMatter(scene, { ...lackingInThree, kinds: pointsAlone('The naive multipass is') }),
  async open(canvas, scene): Promise<Drawing> {
    const { renderer, gl, check, dispose } = createWebGL(canvas, scene);
    const { three, camera, width, height } = scene;
    const lights = scene.lights as readonly PointLight[];
    const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
    const target = new WebGLRenderTarget(width, height, { type: HalfFloatType, ...filter });
    const added = new AddedLights(scene);
    const screen = fullScreen(target);
    const flat = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
    renderer.autoClear = false;
    return {
      gl,
      check,
      render() {
        for (let i = 0; i < lights.length; i++) lights[i].visible = false;
        renderer.setRenderTarget(target);
        renderer.clear();
        renderer.render(three, camera);
        for (let i = 0; i < lights.length; i++) {
          added.light(lights[i]);
          renderer.render(added.scene, camera);
          lights[i].visible = true;
        }
        renderer.setRenderTarget(null);
        renderer.render(screen, flat);
      },
      targetBytes: () => width * height * (8 + 4),
      dispose() {
        added.dispose();
        screen.traverse((object) => {
          if (!(object instanceof Mesh)) return;
          object.geometry.dispose();
          object.material.dispose();
        });
        target.dispose();
        dispose();
      },
    };
  },
};

/** The lit meshes with additive materials, drawn over the base pass for each light. */
class AddedLights {
  readonly scene = new Scene();
  private readonly lamp = new PointLight();
  private readonly caster = new PointLight();
  private readonly materials = new Map<Material, Material>();

  constructor({ three, lights }: StageScene) {
    this.scene.add(this.lamp, this.caster);
    this.caster.castShadow = true;
    const casting = (lights as readonly PointLight[]).find(({ castShadow }) => castShadow);
    if (casting) this.caster.shadow.copy(casting.shadow);
    if (three.fog) {
      this.scene.fog = three.fog.clone();
      this.scene.fog.color.set(0);
    }
    for (const object of three.children) {
      const { material } = object as Mesh;
      if (!material) continue;
      const copy = object.clone(false) as Mesh;
      // the copy has the original's matrix itself, so that it moves with the original
      copy.matrix = object.matrix;
      copy.matrixWorld = object.matrixWorld;
      if (object instanceof InstancedMesh) (copy as InstancedMesh).instanceMatrix = object.instanceMatrix;
      copy.material = Array.isArray(material) ? material.map((each) => this.additive(each)) : this.additive(material);
      this.scene.add(copy);
    }
  }

  /** Copies position, colour, intensity, range and decay of `source` to the only visible light of the pass. */
  light(source: PointLight): void {
    const used = source.castShadow ? this.caster : this.lamp;
    this.lamp.visible = !source.castShadow;
    this.caster.visible = source.castShadow;
    used.position.copy(source.position);
    used.color.copy(source.color);
    used.intensity = source.intensity;
    used.distance = source.distance;
    used.decay = source.decay;
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
    this.lamp.dispose();
    this.caster.dispose();
  }

  private additive(source: Material): Material {
    let copy = this.materials.get(source);
    if (copy) return copy;
    copy = source.clone();
    this.materials.set(source, copy);
    const { lights, emissive } = copy as Material & { lights?: boolean; emissive?: { set(value: number): void } };
    copy.visible = source.visible && (lights === true || 'lightMap' in copy) && !(copy instanceof MeshBasicMaterial);
    // the base pass has already drawn emissive, environment and light maps
    emissive?.set(0);
    for (const map of ['emissiveMap', 'envMap', 'lightMap', 'aoMap']) {
      if (map in copy) (copy as unknown as Record<string, unknown>)[map] = null;
    }
    Object.assign(copy, {
      blending: CustomBlending,
      blendEquation: AddEquation,
      blendSrc: source.transparent ? SrcAlphaFactor : OneFactor,
      blendDst: OneFactor,
      depthWrite: false,
      depthFunc: LessEqualDepth,
    });
    return copy;
  }
}

/** A quad that draws the sum of all passes, converted to sRGB. */
function fullScreen(target: WebGLRenderTarget): Scene {
  const material = new MeshBasicMaterial({ map: target.texture, depthTest: false, depthWrite: false });
  return new Scene().add(new Mesh(new PlaneGeometry(2, 2), material));
}
