import { Color, type Scene, type ToneMapping } from 'three';
import { toneMapColour } from './toneMapColour';

const background = new Color();
const fog = new Color();

/**
 * Tone maps background and fog colours for one frame, which three does not when it draws to the canvas, so that they
 * match a picture tone mapped as a whole.
 */
export const surroundings = {
  toneMap(scene: Scene, toneMapping: ToneMapping, exposure: number): void {
    if (scene.background instanceof Color) {
      background.copy(scene.background);
      toneMapColour(scene.background, toneMapping, exposure);
    }
    if (scene.fog) {
      fog.copy(scene.fog.color);
      toneMapColour(scene.fog.color, toneMapping, exposure);
    }
  },

  /** Restores the colours of background and fog from before the last `toneMap`. */
  restore(scene: Scene): void {
    if (scene.background instanceof Color) scene.background.copy(background);
    scene.fog?.color.copy(fog);
  },
};
