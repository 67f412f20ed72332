/**
 * Drawings of techniques: the idea on the screen or in depth, what the drawing says, and the passes, each with what it
 * writes.
 *
 * @type {Record<string, { idea: 'sum' | 'loop' | 'volumes' | 'half' | 'tiles' | 'depth' | 'clusters', says: string, passes: string[][] }>}
 */
export const drawings = {
  auto: {
    idea: 'tiles',
    says: 'What is in view is counted before anything is drawn; the fastest technique for it draws the frame.',
    passes: [
      ['Count', 'lights in view', 'lights over a pixel'],
      ['Choose', 'one of four'],
      ['Prepare', 'its programs,', 'over some frames'],
      ['Draw'],
    ],
  },
  forward: {
    idea: 'sum',
    says: 'The objects are drawn once for ambient light and once more for each light that reaches them. The passes add up.',
    passes: [
      ['Ambient', 'each object once'],
      ['Light 1', 'objects in its range'],
      ['Light 2 …', 'added'],
      ['Output', 'fog, tone mapping'],
    ],
  },
  'forward-single-pass': {
    idea: 'loop',
    says: 'Each object is drawn once. In every pixel its shader loops over all lights of the scene.',
    passes: [
      ['Opaque', 'a loop over all lights'],
      ['Transparent', 'the same loop'],
    ],
  },
  deferred: {
    idea: 'volumes',
    says: 'Surfaces are drawn once into textures. Then each light is a ball of its range, and shades only the pixels that the ball covers.',
    passes: [
      ['G-buffer', 'albedo, normal,', 'roughness, depth'],
      ['Light volumes', 'light, added up'],
      ['Output', 'fog, tone mapping'],
      ['Transparent', 'forward'],
    ],
  },
  'light-prepass': {
    idea: 'volumes',
    says: 'Only normals and shininess are drawn first. Lights are added up without knowing colours; then the materials are drawn again, lit by that buffer.',
    passes: [
      ['Normals', 'normal, shininess,', 'depth'],
      ['Light buffer', 'diffuse, specular'],
      ['Materials', 'all objects again'],
      ['Transparent', 'forward'],
    ],
  },
  inferred: {
    idea: 'half',
    says: 'A light pre-pass whose buffers have half the resolution: one texel of light for four pixels, joined to the objects by a filter that keeps their edges.',
    passes: [
      ['Normals', 'half resolution,', 'object numbers'],
      ['Light buffer', 'half resolution'],
      ['Materials', 'full resolution'],
      ['Transparent', 'by the same buffer'],
    ],
  },
  'tiled-forward': {
    idea: 'tiles',
    says: 'The screen is cut into tiles. Each tile lists the lights whose range touches it; the materials of its pixels walk that list.',
    passes: [
      ['Light lists', 'one for each tile'],
      ['Opaque', 'walks its list'],
      ['Transparent', 'walks its list'],
    ],
  },
  'tiled-deferred': {
    idea: 'tiles',
    says: 'Surfaces are drawn once into textures. Each tile lists the lights that touch it within its depths; each pixel is shaded once by its list.',
    passes: [
      ['G-buffer', 'albedo, normal,', 'roughness, depth'],
      ['Light lists', 'one for each tile,', 'within its depths'],
      ['Output', 'each pixel once'],
      ['Transparent', 'forward'],
    ],
  },
  'forward-plus': {
    idea: 'depth',
    says: 'Depth is drawn first. A tile then lists only the lights that lie between its nearest and its farthest surface.',
    passes: [
      ['Depth'],
      ['Light lists', 'one for each tile,', 'within its depths'],
      ['Opaque', 'walks its list,', 'nothing twice'],
      ['Transparent', 'forward'],
    ],
  },
  'clustered-forward': {
    idea: 'clusters',
    says: 'Each tile is cut by depth as well, into clusters. A material walks the lights of its pixel’s cluster, however far the surfaces of the tile lie apart.',
    passes: [
      ['Light lists', 'tiles and depths'],
      ['Opaque', 'walks its cluster'],
      ['Transparent', 'walks its cluster'],
    ],
  },
  'clustered-deferred': {
    idea: 'clusters',
    says: 'Surfaces are drawn once into textures. Each pixel is then shaded once by the lights of its cluster; what is transparent walks the same clusters.',
    passes: [
      ['G-buffer', 'albedo, normal,', 'roughness, depth'],
      ['Light lists', 'tiles and depths'],
      ['Output', 'each pixel once'],
      ['Transparent', 'walks its cluster'],
    ],
  },
};
