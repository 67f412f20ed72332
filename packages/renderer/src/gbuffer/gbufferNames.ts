import type { IUniform, Texture } from 'three';
import { capital } from '../microshaders/capital';
import { type GBufferAttachment, gbufferLayout } from './gbufferLayout';

type AttachmentName = (typeof gbufferLayout)[number]['name'];

/** Index of each attachment among the G-buffer's textures and draw buffers. */
export const attachmentIndex = Object.fromEntries(gbufferLayout.map(({ name }, i) => [name, i])) as {
  readonly [name in AttachmentName]: number;
};

/** Uniforms of the microshader `gbufferTextures`: `farol_gNormal` and the like. */
export type GBufferTextureUniforms = {
  -readonly [name in AttachmentName | 'depth' as `farol_g${Capitalize<name>}`]: IUniform<Texture | null>;
};

/** The uniform of each attachment, in order. */
export const textureUniforms = gbufferLayout.map(
  ({ name }) => `farol_g${capital(name)}` as Exclude<keyof GBufferTextureUniforms, 'farol_gDepth'>,
);

export function gbufferTextureUniforms(): GBufferTextureUniforms {
  const uniforms = [...textureUniforms, 'farol_gDepth'].map((name) => [name, { value: null }]);
  return Object.fromEntries(uniforms) as GBufferTextureUniforms;
}

/**
 * Declares the outputs of a shader that draws into attachments: `farol_outNormal` and the like.
 * @param layout - layout of the target: `gbufferLayout`, or one that begins with it
 * @param from - location of the first output, 0 to the number of attachments. Default 1: three's own gl_FragColor has 0
 */
export function attachmentOutputs(layout: readonly GBufferAttachment[] = gbufferLayout, from = 1): string {
  const line = ({ name }: GBufferAttachment, i: number) =>
    `layout(location = ${from + i}) out highp vec4 farol_out${capital(name)};\n`;
  return layout.slice(from).map(line).join('');
}
