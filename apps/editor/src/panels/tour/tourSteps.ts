import { t } from '@farol/editing';

export interface TourStep {
  /** Selector of the control; the first visible match is used. */
  readonly target: string;
  /** Id of the panel with the control, which is brought to the front. */
  readonly panel?: string;
  readonly title: string;
  readonly text: string;
}

/** The steps of the tour, in the user's language. */
export const tourSteps = (): readonly TourStep[] => [
  {
    target: '.viewport-place',
    panel: 'viewport',
    title: t('The picture'),
    text: t(
      'Drag to turn it, wheel to come nearer, Shift and drag to shift it. Hold the right button to look around, and W A S D to fly. By touch: one finger turns, two shift and zoom.',
    ),
  },
  {
    target: '.toolbar-add',
    title: t('Add things'),
    text: t('Meshes, lights, cameras and decals. What you add is selected, and one step back by Ctrl+Z.'),
  },
  {
    target: '.handles, .handles-menu',
    panel: 'viewport',
    title: t('Move, rotate, scale'),
    text: t('Click something in the picture, then W moves it, E rotates it, R scales it. Hold Ctrl to snap.'),
  },
  {
    target: '#panel-hierarchy',
    panel: 'hierarchy',
    title: t('Hierarchy'),
    text: t('Everything in the scene. Drag a line onto another to attach it, F2 renames, H hides, L locks.'),
  },
  {
    target: '#panel-inspector',
    panel: 'inspector',
    title: t('Inspector'),
    text: t('Every value of what is selected. Drag sideways on a number, or type it. Add component gives it more.'),
  },
  {
    target: '#panel-assets',
    panel: 'assets',
    title: t('Assets'),
    text: t('Models, textures and materials. Drop files anywhere on the window, and drag from here into the picture.'),
  },
  {
    target: '.toolbar .technique, .menu-bar',
    title: t('Technique'),
    text: t('How the lights are drawn: the same picture at different speeds. View > Technique has them too.'),
  },
  {
    target: '.toolbar .play',
    title: t('Play'),
    text: t('Runs the scene. Stop puts everything back; what you changed meanwhile can be kept, value by value.'),
  },
  {
    target: '.menu-bar',
    title: t('Menus'),
    text: t(
      'Everything that can be done, with its key. File saves, exports and shares; Ctrl+K finds any command by name.',
    ),
  },
];
