import { ShaderChunk } from 'three';
import { replacePart } from './replaceChunk';
import { sumsLights } from './ThreeChunks';
import { TwinRefusal } from './TwinRefusal';

/** Condition of three's multiscattering compensation, computed once a pixel since 0.186; before, once a light. */
const MULTISCATTERING_GATE =
  '#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )';
const FIRST_LOOP = '#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )';
const INDIRECT = '#if defined( RE_IndirectDiffuse )';
const AMBIENT = 'vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );';
const LOOP = `farol_lightsEvaluated = 0.0;
#ifdef RE_Direct
#ifdef FAROL_SET_PLANE
FAROL_SET_PLANE(geometryPosition)
#endif
#if defined( FAROL_PLAIN_STANDARD ) && ! defined( FAROL_ONE_BY_ONE )
FAROL_SHADE_PLAIN
#else
#ifdef FAROL_TOON
farol_startToon(geometryPosition, geometryNormal);
#endif
FAROL_BEGIN_AREAS
FAROL_FOR_EACH_LIGHT(geometryPosition)
#endif
#endif
`;

/**
 * three's `lights_fragment_begin` with Farol's light loop before three's own loops.
 * @param withThreeLights - whether to keep three's own loops; not in passes of single lights
 * @throws TwinRefusal if the page has changed the chunk
 */
export function lightsFragmentBegin(withThreeLights: boolean): string {
  // the compensation is also needed with only Farol's lights
  let text: string = ShaderChunk.lights_fragment_begin;
  if (sumsLights) text = replacePart(text, MULTISCATTERING_GATE, '#if 1');
  text = replacePart(text, AMBIENT, `${AMBIENT}\nirradiance += farol_ambientIrradiance(geometryNormal);`);
  const start = text.indexOf(FIRST_LOOP);
  const end = text.indexOf(INDIRECT);
  if (start < 0 || end < start) throw new TwinRefusal(FIRST_LOOP);
  return text.slice(0, start) + LOOP + (withThreeLights ? text.slice(start, end) : '') + text.slice(end);
}
