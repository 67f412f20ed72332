/**
 * @typedef {import('./benchOptions.mjs').SceneChoice} SceneChoice
 * @typedef {import('./benchOptions.mjs').Size} Size
 *
 * @typedef {object} Known what a build of the viewer offers
 * @property {string[]} techniques
 * @property {Record<string, string[]>} scenes names of each scene's parameters
 *
 * @typedef {object} BenchCase
 * @property {string} scene as it was asked for, parameters included
 * @property {string} technique
 * @property {number | null} lights how many were asked for; null for a scene whose number is fixed
 * @property {Size} size
 * @property {number} build index of the build
 * @property {string} query of the viewer's address, with its '?'
 */

/**
 * The matrix of one round, so that what is to be compared is drawn one right after the other: scenes, then sizes, lights,
 * techniques, builds. What a build does not have is left out for that build.
 *
 * @param {{ scenes: SceneChoice[] | null, techniques: string[] | null, lights: number[], sizes: Size[] }} options
 * @param {Known[]} builds - the first one says what "all" means
 * @returns {BenchCase[]}
 * @throws {Error} when no build has a scene or a technique, naming those there are
 */
export function benchCases(options, builds) {
  const scenes = options.scenes ?? Object.keys(builds[0].scenes).map((name) => ({ name, parameters: {} }));
  const techniques = options.techniques ?? builds[0].techniques;
  check(
    'scene',
    scenes.map(({ name }) => name),
    builds.flatMap((build) => Object.keys(build.scenes)),
  );
  check(
    'technique',
    techniques,
    builds.flatMap((build) => build.techniques),
  );
  /** @type {BenchCase[]} */
  const cases = [];
  for (const scene of scenes) {
    for (const size of options.sizes) {
      for (const lights of lightCounts(scene, builds, options.lights)) {
        for (const technique of techniques) {
          builds.forEach((known, build) => {
            const fields = known.scenes[scene.name];
            if (!fields || !known.techniques.includes(technique)) return;
            const query = viewerQuery(scene, technique, size, lightParameters(fields, lights));
            cases.push({ scene: sceneLabel(scene), technique, lights, size, build, query });
          });
        }
      }
    }
  }
  return cases;
}

/** Key of a case, equal in every build and round: a row of the table. @param {BenchCase} benchCase */
export function caseKey({ scene, technique, lights, size }) {
  return [scene, `${size.width}×${size.height}`, lights ?? '', technique].join(' ');
}

/** @param {SceneChoice} scene */
function sceneLabel({ name, parameters }) {
  return [name, ...Object.entries(parameters).map(([key, value]) => `${key}=${value}`)].join(':');
}

/**
 * How a scene is told a number of lights: `lights`, or `m` lights along a side of a square; nothing where it has neither.
 *
 * @param {readonly string[]} fields @param {number | null} lights
 * @returns {Record<string, number>}
 */
export function lightParameters(fields, lights) {
  if (lights === null) return {};
  if (fields.includes('lights')) return { lights };
  return fields.includes('m') ? { m: Math.round(Math.sqrt(lights)) } : {};
}

/** @param {SceneChoice} scene @param {Known[]} builds @param {number[]} lights @returns {(number | null)[]} */
function lightCounts(scene, builds, lights) {
  const fields = builds.find((build) => build.scenes[scene.name])?.scenes[scene.name] ?? [];
  const chosen = 'lights' in scene.parameters || 'm' in scene.parameters;
  return chosen || Object.keys(lightParameters(fields, 1)).length === 0 ? [null] : lights;
}

/** @param {SceneChoice} scene @param {string} technique @param {Size} size @param {Record<string, number>} lights */
function viewerQuery(scene, technique, size, lights) {
  const entries = { scene: scene.name, technique, ...scene.parameters, ...lights, time: 0, ...size, dpr: 1, gui: 0 };
  return `?${new URLSearchParams(Object.entries(entries).map(([name, value]) => [name, String(value)]))}`;
}

/** @param {string} what @param {string[]} asked @param {string[]} known */
function check(what, asked, known) {
  const unknown = asked.filter((name) => !known.includes(name));
  if (unknown.length === 0) return;
  throw new Error(`No ${what} ${unknown.join(', ')}: known are ${[...new Set(known)].join(', ')}.`);
}
