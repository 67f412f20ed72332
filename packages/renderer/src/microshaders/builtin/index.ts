import type { MicroShader } from '../MicroShader';
import { parseMicroShader } from '../parseMicroShader';
import accumulatedOutput from './accumulatedOutput.glsl?raw';
import ambientLight from './ambientLight.glsl?raw';
import background from './background.glsl?raw';
import deferredOutput from './deferredOutput.glsl?raw';
import depthMode from './depthMode.glsl?raw';
import depthOnly from './depthOnly.glsl?raw';
import farthest from './farthest.glsl?raw';
import fullscreen from './fullscreen.glsl?raw';
import gbufferRead from './gbufferRead.glsl?raw';
import gbufferWrite from './gbufferWrite.glsl?raw';
import globalLightsFragment from './globalLightsFragment.glsl?raw';
import heatMap from './heatMap.glsl?raw';
import heatScale from './heatScale.glsl?raw';
import incidentLight from './incidentLight.glsl?raw';
import lightAttenuation from './lightAttenuation.glsl?raw';
import lightList from './lightList.glsl?raw';
import lightListClustered from './lightListClustered.glsl?raw';
import lightMask from './lightMask.glsl?raw';
import lightLoopAll from './lightLoopAll.glsl?raw';
import lightLoopNone from './lightLoopNone.glsl?raw';
import lightLoopOne from './lightLoopOne.glsl?raw';
import lightLoopTiled from './lightLoopTiled.glsl?raw';
import lightOneByOne from './lightOneByOne.glsl?raw';
import lightTable from './lightTable.glsl?raw';
import lightTiles from './lightTiles.glsl?raw';
import lightVolumeCone from './lightVolumeCone.glsl?raw';
import lightVolumeFragment from './lightVolumeFragment.glsl?raw';
import lightVolumeWide from './lightVolumeWide.glsl?raw';
import lightVolumeSphere from './lightVolumeSphere.glsl?raw';
import octahedralNormal from './octahedralNormal.glsl?raw';
import output from './output.glsl?raw';
import shadeSurface from './shadeSurface.glsl?raw';
import roundToHalf from './roundToHalf.glsl?raw';
import shadePlain from './shadePlain.glsl?raw';
import shading from './shading.glsl?raw';
import shadeThree from './shadeThree.glsl?raw';
import shadeToon from './shadeToon.glsl?raw';
import storedDistance from './storedDistance.glsl?raw';
import tileDepth from './tileDepth.glsl?raw';
import tileDepthBlocks from './tileDepthBlocks.glsl?raw';
import tiledOutput from './tiledOutput.glsl?raw';
import tileMask from './tileMask.glsl?raw';
import tileSummary from './tileSummary.glsl?raw';
import unproject from './unproject.glsl?raw';
import viewport from './viewport.glsl?raw';
import volumeLighting from './volumeLighting.glsl?raw';

/** Sources by name. A new microshader is a file and a line here. */
const sources = {
  accumulatedOutput,
  ambientLight,
  background,
  deferredOutput,
  depthMode,
  depthOnly,
  farthest,
  fullscreen,
  gbufferRead,
  gbufferWrite,
  globalLightsFragment,
  heatMap,
  heatScale,
  incidentLight,
  lightAttenuation,
  lightList,
  lightListClustered,
  lightLoopAll,
  lightMask,
  lightLoopNone,
  lightLoopOne,
  lightLoopTiled,
  lightOneByOne,
  lightTable,
  lightTiles,
  lightVolumeCone,
  lightVolumeFragment,
  lightVolumeSphere,
  lightVolumeWide,
  octahedralNormal,
  output,
  roundToHalf,
  shadePlain,
  shadeSurface,
  shading,
  shadeThree,
  shadeToon,
  storedDistance,
  tileDepth,
  tileDepthBlocks,
  tiledOutput,
  tileMask,
  tileSummary,
  unproject,
  viewport,
  volumeLighting,
};

export type BuiltinMicroShader = keyof typeof sources;

export const builtinMicroShaders: readonly MicroShader[] = [
  ...Object.entries(sources).map(([name, text]) => parseMicroShader(name, text)),
];
