import {
  BufferAttribute,
  BufferGeometry,
  FloatType,
  type Matrix4,
  Mesh,
  MeshLambertMaterial,
  NearestFilter,
  NoBlending,
  type Texture,
  WebGLRenderTarget,
} from 'three';
import { forwardTwins } from '../../materials/forwardTwin';
import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import { targetBytes } from '../../gpu/targetBytes';
import type { TwinKind } from '../../materials/TwinKind';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import surroundingNormals from './surroundingNormals.glsl?raw';

/** Number of normals in surroundingNormals.glsl, a texel each. */
const NORMALS = 9;

/** Matches the start of a shader's main(), however it is spaced. */
const MAIN = /\bvoid\s+main\s*\(\s*\)\s*\{/;
const NORMAL = 'vec3 farol_axisNormal;\n#define normal farol_axisNormal\n';
const PLACE = `gl_Position = vec4((float(farol_texelIndex) + (farol_isRightCorner ? 1.0 : 0.0)) / ${(NORMALS / 2).toFixed(1)} - 1.0,
  farol_isUpperCorner ? 1.0 : -1.0, 0.0, 1.0);`;

/** White Lambert material without lights: outputs the light that three and effects add to a surface, one texel for each normal. */
function surroundingsKind(): TwinKind {
  const kind = forwardTwins('lightLoopNone')('final').whole;
  return {
    ...kind,
    key: `${kind.key}-particles`,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      const vertex = shader.vertexShader.replace(MAIN, (main) => `${NORMAL}${main}\n${surroundingNormals}`);
      shader.vertexShader = beforeLastBrace(vertex, PLACE);
    },
  };
}

/** Makes a quad for each texel. The shader computes positions and normals; three only tests that the attributes exist. */
function texels(): BufferGeometry {
  const none = new BufferAttribute(new Float32Array(18 * NORMALS), 3);
  const geometry = new BufferGeometry().setAttribute('position', none).setAttribute('normal', none);
  geometry.setDrawRange(0, 6 * NORMALS);
  return geometry;
}

/**
 * Indirect light at an emitter: environment map, ambient and hemisphere lights, light probes, and light that effects add. Shades
 * a white Lambert surface for nine normals, and computes spherical harmonics of second order from these.
 * @see Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps
 */
export class ParticleSurroundings {
  private readonly kind = surroundingsKind();
  private readonly mesh = new Mesh(texels(), new MeshLambertMaterial());
  private readonly item: RenderItem;

  constructor() {
    const { mesh } = this;
    mesh.matrixAutoUpdate = mesh.matrixWorldAutoUpdate = false;
    Object.assign(mesh.material, {
      name: 'Farol light around particles',
      fog: false,
      toneMapped: false,
      depthTest: false,
      depthWrite: false,
    });
    mesh.material.blending = NoBlending;
    this.item = {
      id: mesh.id,
      object: mesh,
      geometry: mesh.geometry,
      material: mesh.material,
      materialVariant: 0,
      group: null,
      groupOrder: 0,
      renderOrder: 0,
      z: 0,
      shading: 'lit',
      route: 'forward',
      ownShader: false,
      layered: false,
      drawn: false,
    };
  }

  /**
   * Draws the indirect light at an emitter's position. Binds the target.
   * @param place - world matrix of the emitter
   */
  draw(frame: Frame, target: WebGLRenderTarget, place: Matrix4): void {
    this.mesh.matrixWorld.identity().copyPosition(place);
    frame.bind(target);
    frame.drawTwin(this.item, this.kind);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** Indirect light at one emitter. */
export class SurroundingLight {
  private readonly target = new WebGLRenderTarget(NORMALS, 1, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });

  get bytes(): number {
    return targetBytes(this.target);
  }

  get texture(): Texture {
    return this.target.texture;
  }

  find(frame: Frame, surroundings: ParticleSurroundings, place: Matrix4): void {
    surroundings.draw(frame, this.target, place);
  }

  dispose(): void {
    this.target.dispose();
  }
}
