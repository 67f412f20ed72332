// an optional peer dependency: when it is absent, bundlers fail on named imports, but not on a namespace
import * as postprocessing from 'postprocessing';
import { Matrix3, type Texture, Uniform } from 'three';

const balanceCode = `uniform mat3 balance;
void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) {
  outputColor = vec4(max(balance * inputColor.rgb, vec3(0.0)), inputColor.a);
}`;

/** Makes the picture warmer or cooler by a matrix of linear colours. */
export class WhiteBalanceEffect extends postprocessing.Effect {
  readonly balance = new Matrix3();

  constructor() {
    super('WhiteBalanceEffect', balanceCode, { blendFunction: postprocessing.BlendFunction.SRC });
    this.uniforms.set('balance', new Uniform(this.balance));
  }
}

const depthCode = `uniform highp sampler2D sceneDepth;
void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) {
  gl_FragDepth = texture2D(sceneDepth, uv).r;
  outputColor = inputColor;
}`;

/** Copies the scene's depth to the output, for things drawn over the picture. */
export class DepthEffect extends postprocessing.Effect {
  private readonly sceneDepth = new Uniform<Texture | null>(null);

  constructor() {
    super('DepthEffect', depthCode, { blendFunction: postprocessing.BlendFunction.SRC });
    this.uniforms.set('sceneDepth', this.sceneDepth);
  }

  set texture(texture: Texture | null) {
    this.sceneDepth.value = texture;
  }
}
