import { Matrix4, type PerspectiveCamera, Vector2, Vector3, Vector4 } from 'three';
import type { TwinAdapter } from '../../frame/TwinAdapter';
import type { TwinKind } from '../../materials/TwinKind';
import eyesFragment from './eyesFragment.glsl?raw';
import eyesVertex from './eyesVertex.glsl?raw';

const VERSION = '#version 300 es\n';
/** Directive that must stand before all other code; three puts its own lines before the part that materials may change. */
const EXTENSION = '#extension GL_OVR_multiview2 : require\n';
const FOG = '#include <fog_vertex>';
// blanks are optional: a build takes them out of Farol's own chunks
const VIEW_DIRECTION = /normalize\( ?vViewPosition ?\)/g;
/** Place of a pixel in the host's target, see targetPixel.glsl. */
const PIXEL = /gl_FragCoord\.xy ?\+ ?farol_targetOrigin/g;
/** Place of a pixel in the picture whose tiles have light lists, see lightLoopClustered.glsl. */
const TILE = /gl_FragCoord\.xy ?- ?farol_offset\) ?>> ?farol_grid\.x/g;
const offset = new Matrix4();

/** Camera of an eye from three's WebXRManager. */
export type Eye = PerspectiveCamera & { readonly viewport: Vector4 };

/** Twins whose programs draw both eyes by one call; lighting is in the view space of the union camera. */
export class EyeTwins implements TwinAdapter {
  private readonly kinds = new WeakMap<TwinKind, TwinKind>();
  private gl!: WebGL2RenderingContext;
  private shaderSource!: WebGL2RenderingContext['shaderSource'];
  /** Descriptor of the host's `shaderSource`, if it has replaced WebGL's on the context. */
  private hostMethod: PropertyDescriptor | undefined;
  private readonly uniforms = {
    farol_eyeProjections: { value: [new Matrix4(), new Matrix4()] },
    farol_eyesWS: { value: [new Vector3(), new Vector3()] },
    farol_eyesVS: { value: [new Vector3(), new Vector3()] },
    farol_unionPixels: { value: new Vector4() },
    farol_unionLast: { value: new Vector2() },
    farol_eyeOrigins: { value: [new Vector2(), new Vector2()] },
  };

  adapt(kind: TwinKind): TwinKind {
    let both = this.kinds.get(kind);
    if (both === undefined) this.kinds.set(kind, (both = this.bothOf(kind)));
    return both;
  }

  /** @param camera - camera whose frustum contains both eyes' */
  set(camera: PerspectiveCamera, eyes: readonly Eye[]): void {
    const { farol_eyeProjections, farol_eyesWS, farol_eyesVS, farol_eyeOrigins } = this.uniforms;
    const { farol_unionPixels, farol_unionLast } = this.uniforms;
    const { z: width, w: height } = eyes[0].viewport;
    for (let i = 0; i < 2; i++) {
      offset.multiplyMatrices(eyes[i].matrixWorldInverse, camera.matrixWorld);
      farol_eyeProjections.value[i].multiplyMatrices(eyes[i].projectionMatrix, offset);
      const world = farol_eyesWS.value[i].setFromMatrixPosition(eyes[i].matrixWorld);
      farol_eyeOrigins.value[i].set(eyes[i].viewport.x, eyes[i].viewport.y);
      farol_eyesVS.value[i].copy(world).applyMatrix4(camera.matrixWorldInverse);
    }
    const p = camera.projectionMatrix.elements;
    const [x, y] = [width / 2, height / 2];
    farol_unionPixels.value.set(x * p[0], y * p[5], x * (1 - p[8]), y * (1 - p[9]));
    farol_unionLast.value.set(width - 1, height - 1);
  }

  /** From here on, adds the extension's directive to sources of programs that read the eye's index. */
  begin(gl: WebGL2RenderingContext): void {
    this.hostMethod = Object.getOwnPropertyDescriptor(gl, 'shaderSource');
    this.shaderSource = gl.shaderSource;
    this.gl = gl;
    gl.shaderSource = this.extended;
  }

  end(): void {
    const { gl, hostMethod } = this;
    if (hostMethod === undefined) Reflect.deleteProperty(gl, 'shaderSource');
    else Object.defineProperty(gl, 'shaderSource', hostMethod);
  }

  private readonly extended = (shader: WebGLShader, source: string): void => {
    const names = source.includes('gl_ViewID_OVR');
    this.shaderSource.call(this.gl, shader, names ? source.replace(VERSION, VERSION + EXTENSION) : source);
  };

  private bothOf(kind: TwinKind): TwinKind {
    return {
      ...kind,
      key: `${kind.key}, both eyes`,
      patch: (shader, source, header) => {
        kind.patch(shader, source, header);
        Object.assign(shader.uniforms, this.uniforms);
        // fog depends on the eye's depth, the w of its clip space
        const vertex = shader.vertexShader.replace(FOG, `${FOG}\n#ifdef USE_FOG\n  vFogDepth = gl_Position.w;\n#endif`);
        shader.vertexShader = `${eyesVertex}\n${vertex}`;
        const fragment = shader.fragmentShader
          .replaceAll(VIEW_DIRECTION, 'normalize( vViewPosition + farol_eyesVS[gl_ViewID_OVR] )')
          .replaceAll(TILE, 'farol_unionPixel(positionVS)) >> farol_grid.x')
          .replaceAll(PIXEL, '$& + farol_eyeOrigins[gl_ViewID_OVR]');
        shader.fragmentShader = `${eyesFragment}\n${fragment}`;
      },
    };
  }
}
