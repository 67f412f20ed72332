/** Sentences of `ViewInfo.problem`, by what a frame lacks. */
export const problems = {
  occlusion:
    'Ambient occlusion is not in this frame: switch it on, with a technique that has depth before it lights, such as Deferred shading, Light pre-pass or Forward+.',
  motion: 'Motion is not in this frame: switch on the anti-aliasing TAA.',
  reactive: 'The reactive mask is not in this frame: switch on the anti-aliasing TAA.',
  notReactive: 'The reactive mask is empty: it holds particles, and none is in view.',
  lightBuffer: 'The light buffer is not in this frame: choose the technique Light pre-pass or Inferred lighting.',
  shadowAtlas: 'No shadow map is in this frame: let a light that is in view cast shadows.',
  imageAtlas: 'No profile or image of a light lies in the atlas: give a light that is in view a photometric profile.',
  fog: 'Volumetric fog is not in this frame: switch it on, and look with a camera that has perspective.',
} as const;
