import type { EditorPlugin } from '../../api/EditorPlugin';
import { Flicker } from './Flicker';
import { flickerAll } from './flickerAll';
import { share } from './share';
import { vignette } from './vignette';

/**
 * Example plugin with one of everything that can be added: a field type (a share, with a slider), a component using it
 * (Flicker), a technique (Vignette), a command and a panel.
 */
export const lantern: EditorPlugin = {
  name: 'Lantern',
  fieldTypes: [share],
  components: [Flicker],
  techniques: { vignette },
  actions: [flickerAll],
  panels: [
    {
      id: 'lantern',
      title: 'Lantern',
      icon: 'lamp',
      place: 'right',
      load: () => import('./LanternPanel').then(({ LanternPanel }) => LanternPanel),
    },
  ],
};
