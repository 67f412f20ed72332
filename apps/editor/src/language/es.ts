import type { Texts } from '@farol/editing';
import { es as editing, esOfApps } from '@farol/editing/es';
import { actions } from './es/actions';
import { agent } from './es/agent';
import { animation } from './es/animation';
import { areaLights } from './es/areaLights';
import { arrange } from './es/arrange';
import { assetNames } from './es/assetNames';
import { bake } from './es/bake';
import { buildings } from './es/buildings';
import { components } from './es/components';
import { edits } from './es/edits';
import { engine } from './es/engine';
import { library } from './es/library';
import { lights } from './es/lights';
import { materials } from './es/materials';
import { messages } from './es/messages';
import { panels } from './es/panels';
import { particles } from './es/particles';
import { photometry } from './es/photometry';
import { physics } from './es/physics';
import { picture } from './es/picture';
import { pixelLighting } from './es/pixelLighting';
import { player } from './es/player';
import { profiles } from './es/profiles';
import { rendering } from './es/rendering';
import { sunAndMoon } from './es/sunAndMoon';
import { triggers } from './es/triggers';
import { scripts } from './es/scripts';
import { surfaces } from './es/surfaces';
import { samples } from './es/samples';
import { scriptRuns } from './es/scriptRuns';
import { timeline } from './es/timeline';
import { views } from './es/views';
import { welcome } from './es/welcome';
import { messageTranslator } from './messageTable';

/** Translates messages of the engine to Spanish. */
export const ofEngine = messageTranslator(engine);

/** All texts of the editor in Spanish, keyed by the English ones. */
export const es: Texts = {
  ...editing,
  ...esOfApps,
  ...actions,
  ...agent,
  ...animation,
  ...areaLights,
  ...arrange,
  ...assetNames,
  ...bake,
  ...buildings,
  ...components,
  ...edits,
  ...library,
  ...lights,
  ...materials,
  ...messages,
  ...panels,
  ...particles,
  ...photometry,
  ...physics,
  ...picture,
  ...pixelLighting,
  ...player,
  ...profiles,
  ...rendering,
  ...sunAndMoon,
  ...triggers,
  ...scripts,
  ...samples,
  ...surfaces,
  ...scriptRuns,
  ...timeline,
  ...views,
  ...welcome,
};
