import { expect, it } from 'vitest';
import { capital } from '../microshaders/capital';
import { type GBufferAttachment, gbufferLayout } from './gbufferLayout';
import { shadingModels, surfaceFlags } from './surfaceFlags';

// after a change of the tables: npx vitest run --config packages/vitest.config.ts gbufferChunks -u

it('gbufferTextures.glsl is made from the rows of the G-buffer', async () => {
  const samplers = gbufferLayout.map(({ name, ...row }: GBufferAttachment) => {
    const texture = `farol_g${capital(name)}`;
    return `uniform ${row.precision ?? 'highp'} sampler2D ${texture};
vec4 ${texture}At(const in ivec2 pixel) { return texelFetch(${texture}, pixel, 0); }
`;
  });
  await expect(`// Reads the attachments of the G-buffer, and its depth.
// Farol; made from the rows of gbuffer/gbufferLayout.ts by gbuffer/gbufferChunks.test.ts
${samplers.join('')}uniform highp sampler2D farol_gDepth;
float farol_gDepthAt(const in ivec2 pixel) { return texelFetch(farol_gDepth, pixel, 0).r; }
`).toMatchFileSnapshot('./gbufferTextures.glsl');
});

it('surfaceFlags.glsl is made from the tables of flags', async () => {
  const models = Object.entries(shadingModels).map(
    ([name, value]) => `const int FAROL_${name.toUpperCase()} = ${value};\n`,
  );
  const flags = Object.entries(surfaceFlags).map(
    ([name, bit]) => `bool farol_${name}(const in int flags) { return (flags & ${bit}) != 0; }\n`,
  );
  await expect(`// Flags of a surface: its shading model, fog, shadows and the like.
// Farol; made from the tables of gbuffer/surfaceFlags.ts by gbuffer/gbufferChunks.test.ts
//? farol_unpackFlags(farol_packFlags(13)) == 13
//? farol_hasFog(13) == true
//? farol_receivesShadows(13) == false
${models.join('')}const int FAROL_RECEIVES_SHADOWS = ${surfaceFlags.receivesShadows};
const int FAROL_HAS_VERTEX_NORMAL = ${surfaceFlags.hasVertexNormal};
const int FAROL_IS_REVERSED = ${surfaceFlags.isReversed};
int farol_shadingModel(const in int flags) { return flags & 3; }
float farol_packFlags(const in int flags) { return float(flags) / 255.0; }
int farol_unpackFlags(const in float stored) { return int(stored * 255.0 + 0.5); }
${flags.join('')}`).toMatchFileSnapshot('./surfaceFlags.glsl');
});
