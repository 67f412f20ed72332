import { t } from '@farol/editing';
import { type View, views } from '@farol/renderer';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { Tool } from '../model/Tools';
import type { IconName } from '../style/iconPaths';
import type { Shading } from '../viewport/shading/Shading';

/** An action that switches a setting of the viewport. */
const toggle = (
  setting: 'continuous' | `show${'Colliders' | 'Grid' | 'Icons' | 'PictureEffects' | 'Ranges' | 'Statistics'}`,
  id: string,
  label: string,
  icon: IconName,
): Action => ({
  id,
  label,
  icon,
  run({ viewport }) {
    viewport[setting] = !viewport[setting];
  },
  checked: ({ viewport }) => viewport[setting],
});

export const showGrid = toggle('showGrid', 'view.grid', 'Grid', 'grid');
export const showIcons = toggle('showIcons', 'view.icons', 'Icons of lights and cameras', 'point');

/** Shows ranges of all lights, or only of selected ones. */
export const showRanges = toggle(
  'showRanges',
  'view.ranges',
  'Ranges of all lights, not of selected ones alone',
  'ranges',
);

/** Shows colliders of all objects, or only of selected ones. */
export const showColliders = toggle(
  'showColliders',
  'view.colliders',
  'Colliders and joints of all objects, not of selected ones alone',
  'collider',
);

/** Shows the scene's effects, such as depth of field, which can be in the way of editing. */
export const showPictureEffects = toggle(
  'showPictureEffects',
  'view.pictureEffects',
  'Picture effects: bloom, depth of field, grading, vignette',
  'contrast',
);

export const continuous = toggle('continuous', 'view.continuous', 'Draw without pause, to see frame rates', 'motion');
export const showStatistics = toggle('showStatistics', 'view.statistics', 'Frame statistics', 'chart');

/** An action that opens a tool over the picture, or closes it when it is open. @param tool - the tool's id */
const opener = (
  tool: string,
  rest: Pick<Action, 'id' | 'label' | 'keys'>,
  make: (viewport: EditorApi['viewport']) => Promise<Tool>,
): Action => ({
  ...rest,
  async run({ viewport, tools }) {
    if (tools.current?.id === tool) tools.end();
    else tools.open(await make(viewport));
  },
  checked: ({ tools }) => tools.current?.id === tool,
});

/** Opens the tool that measures the distance between two clicked points. */
export const measureDistance = opener(
  'measure',
  { id: 'view.measure-distance', label: 'Measure distance', keys: ['M'] },
  async (viewport) => new (await import('../viewport/placing/MeasureTool')).MeasureTool(viewport),
);

/** Opens the tool that measures the light at a clicked point. */
export const measureLight = opener(
  'light-meter',
  { id: 'view.light-meter', label: 'Light meter' },
  async (viewport) => new (await import('../viewport/illuminance/LightMeterTool')).LightMeterTool(viewport),
);

/** Opens the tool that lists how much each light adds to a clicked pixel. */
export const explainPixel = opener(
  'pixel-lighting',
  { id: 'view.explain-pixel', label: 'Explain a pixel', keys: ['Shift+M'] },
  async (viewport) => new (await import('../viewport/pixelLighting/PixelLightingTool')).PixelLightingTool(viewport),
);

/** Shows how much light falls on surfaces, by false colours. */
export const showIlluminance: Action = {
  id: 'view.illuminance',
  label: 'False colours of illuminance',
  async run({ viewport }) {
    if (viewport.painter?.isIlluminance) return void (viewport.painter = null);
    const { IlluminancePainter } = await import('../viewport/illuminance/IlluminancePainter');
    viewport.painter = new IlluminancePainter(viewport);
  },
  checked: ({ viewport }) => viewport.painter?.isIlluminance ?? false,
};

/** Switches between one view, and four views: top, front, right and the main one. */
export const quadView: Action = {
  id: 'view.quad',
  label: 'Four views',
  keys: ['Ctrl+Alt+Q'],
  icon: 'quad',
  run({ preferences, viewport }) {
    const quad = !viewport.isQuad;
    preferences.setState(({ views }) => ({ views: { ...views, quad } }));
  },
  checked: ({ viewport }) => viewport.isQuad,
};

/** Activates the next of four views. */
export const nextView: Action = {
  id: 'view.nextView',
  label: 'Next view',
  keys: ['Ctrl+Alt+W'],
  run({ viewport }) {
    viewport.panes.activateNext(1);
    viewport.canvas.focus();
  },
  enabled: ({ viewport }) => viewport.isQuad,
};

/** Aims the side views at the main view's target again. */
export const resetViews: Action = {
  id: 'view.resetViews',
  label: 'Bring the other views to where this one looks',
  run({ viewport }) {
    viewport.panes.lookFromSides();
    viewport.viewChanged();
  },
  enabled: ({ viewport }) => viewport.isQuad,
};

/** Sets the active view's shading, and remembers it. */
export function setShading({ viewport, preferences }: EditorApi, shading: Shading): void {
  const { active } = viewport.panes;
  viewport.shade(active, shading);
  preferences.setState(({ views }) => ({
    views: { ...views, shadings: { ...views.shadings, [active.name]: shading } },
  }));
}

const shading = (name: Shading & string, label: string): Action => ({
  id: `view.shading.${name}`,
  label,
  run: (editor) => setShading(editor, name),
  checked: ({ viewport }) => viewport.shading === name,
  enabled: ({ viewport }) => viewport.painter === null,
});

/** One action for each shading of the active view. */
export const shadings: readonly Action[] = [
  shading('scene', "As the scene's technique lights it"),
  shading('unlit', 'Unlit colours'),
  shading('clay', 'Clay'),
  shading('wireframe', 'Wireframe'),
];

/** Opens the viewport's menu of shadings. */
export const showShadings: Action = {
  id: 'view.shadingMenu',
  label: 'Choose the shading…',
  keys: ['Z'],
  run: ({ viewport }) => viewport.shadingAsked.emit(),
  enabled: ({ viewport }) => viewport.painter === null,
};

/** English name of a debug view. */
export const englishViewLabel = (view: View): string =>
  view.charAt(0).toUpperCase() + view.slice(1).replaceAll('-', ' ');

/** Name of a debug view, in the user's language. */
export const viewLabel = (view: View): string => t(englishViewLabel(view));

export const techniqueActions = ({ viewport: { farol } }: EditorApi): Action[] =>
  Object.entries(farol.techniques).map(([name, { label }]) => ({
    id: `technique.${name}`,
    label,
    icon: 'lamp',
    run({ viewport }) {
      viewport.technique = name as typeof viewport.technique;
    },
    checked: ({ viewport }) => viewport.technique === name,
  }));

export const viewActions: readonly Action[] = views.map((view) => ({
  id: `shown.${view}`,
  label: englishViewLabel(view),
  icon: 'eye',
  run({ viewport }) {
    viewport.view = view;
  },
  checked: ({ viewport }) => viewport.view === view,
}));
