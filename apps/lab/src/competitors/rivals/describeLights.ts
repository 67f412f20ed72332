import {
  type AmbientLight,
  type DirectionalLight,
  type HemisphereLight,
  type Light,
  type PointLight,
  type SpotLight,
  Vector3,
} from 'three';
import type { Rgb, RivalDirectional, RivalHemisphere, RivalPoints, RivalScene, RivalSpot, Xyz } from './RivalScene';

type StillLights = Pick<RivalScene, 'ambient' | 'hemispheres' | 'directionals' | 'spots'>;

const colourOf = ({ color, intensity }: Light): Rgb => [color.r * intensity, color.g * intensity, color.b * intensity];

const from = new Vector3();
const to = new Vector3();

/** Unit vector from a light to its target. */
function directionOf(light: DirectionalLight | SpotLight): Xyz {
  light.updateWorldMatrix(true, false);
  light.target.updateWorldMatrix(true, false);
  from.setFromMatrixPosition(light.matrixWorld);
  to.setFromMatrixPosition(light.target.matrixWorld);
  return to.sub(from).normalize().toArray();
}

const isPoint = (light: Light): light is PointLight => (light as PointLight).isPointLight === true;

function checkFalloff({ name, distance, decay }: PointLight | SpotLight): void {
  if (!(distance > 0)) throw new Error(`Light ${name || 'without a name'} has no range: clustered lights need one.`);
  if (decay !== 2) {
    throw new Error(`Light ${name || 'without a name'} has decay ${decay}: the Lab gives other engines only 2.`);
  }
}

function describeSpot(light: SpotLight): RivalSpot {
  checkFalloff(light);
  if (light.map) throw new Error(`Light ${light.name || 'without a name'} has a cookie: other engines get none.`);
  const direction = directionOf(light);
  return {
    colour: colourOf(light),
    position: from.setFromMatrixPosition(light.matrixWorld).toArray(),
    direction,
    range: light.distance,
    angle: light.angle,
    innerAngle: light.angle * (1 - light.penumbra),
  };
}

/** Converts lights that do not move. @throws Error for kinds and falloffs that the Lab does not convert */
export function describeStillLights(lights: readonly Light[]): StillLights {
  const ambient: [number, number, number] = [0, 0, 0];
  const hemispheres: RivalHemisphere[] = [];
  const directionals: RivalDirectional[] = [];
  const spots: RivalSpot[] = [];
  for (const light of lights) {
    if (light.castShadow)
      throw new Error(`Light ${light.name || 'without a name'} casts shadows: other engines get none.`);
    if ((light as AmbientLight).isAmbientLight) {
      colourOf(light).forEach((part, k) => (ambient[k] += part));
    } else if ((light as HemisphereLight).isHemisphereLight) {
      const { groundColor, intensity } = light as HemisphereLight;
      light.updateWorldMatrix(true, false);
      const up = from.setFromMatrixPosition(light.matrixWorld).normalize().toArray();
      const ground: Rgb = [groundColor.r * intensity, groundColor.g * intensity, groundColor.b * intensity];
      hemispheres.push({ sky: colourOf(light), ground, up });
    } else if ((light as DirectionalLight).isDirectionalLight) {
      directionals.push({ colour: colourOf(light), direction: directionOf(light as DirectionalLight) });
    } else if ((light as SpotLight).isSpotLight) {
      spots.push(describeSpot(light as SpotLight));
    } else {
      throw new Error(`Light ${light.name || 'without a name'} is a ${light.type}: other engines do not get it.`);
    }
  }
  return { ambient, hemispheres, directionals, spots };
}

/**
 * Converts point lights at their current places.
 * @throws Error for a light without range, with a decay other than 2, or with shadows
 */
export function describePoints(lights: readonly Light[]): RivalPoints {
  const count = lights.length;
  const points = {
    count,
    colours: new Float32Array(count * 3),
    ranges: new Float32Array(count),
    positions: new Float32Array(count * 3),
  };
  lights.forEach((light, i) => {
    if (!isPoint(light)) {
      throw new Error(
        `Light ${light.name || 'without a name'} is a ${light.type}: other engines get moving points only.`,
      );
    }
    checkFalloff(light);
    if (light.castShadow)
      throw new Error(`Light ${light.name || 'without a name'} casts shadows: other engines get none.`);
    points.colours.set(colourOf(light), i * 3);
    points.ranges[i] = light.distance;
  });
  writePositions(lights, points.positions);
  return points;
}

/** Writes the lights' world positions, [n, 3]; allocates nothing. */
export function writePositions(lights: readonly Light[], positions: Float32Array): void {
  for (let i = 0; i < lights.length; i++) {
    const light = lights[i];
    // a child of the scene itself has its world position in `position`
    if (light.parent && light.parent.parent) {
      light.updateWorldMatrix(true, false);
      const { elements } = light.matrixWorld;
      positions[i * 3] = elements[12];
      positions[i * 3 + 1] = elements[13];
      positions[i * 3 + 2] = elements[14];
    } else {
      positions[i * 3] = light.position.x;
      positions[i * 3 + 1] = light.position.y;
      positions[i * 3 + 2] = light.position.z;
    }
  }
}
