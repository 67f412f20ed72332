import { type Language, labelOfField, languages, t, textLanguage } from '@farol/editing';
import { scenes } from '@farol/scenes';
import { type Field, type FieldValue, isFieldVisible } from '@farol/engine/fields';
import { openBeside } from '@farol/engine/files';
import { techniques } from '@farol/renderer';
import GUI, { type Controller } from 'lil-gui';
import { chooseFiles } from '../chooseFiles';
import { modelParameters } from '../model/modelScene';
import { effectEntries } from '../state/effectParameters';
import { known } from '../state/known';
import type { ViewerState } from '../state/ViewerState';
import type { Viewer } from '../Viewer';
import { StatisticsPanel } from './StatisticsPanel';

/** Ignores a failure that a message on the page already explains. */
const ignore = () => {};

/** Menu label of an anti-aliasing method. */
function labelOf(name: string): string {
  return name === 'none' ? t('None') : t(effectEntries[name].label);
}

/** Choices of the menu: values by label; the default label is the capitalised name. */
const labelled = (names: readonly string[], labels: Record<string, string> = {}): Record<string, string> =>
  Object.fromEntries(
    names.map((name) => [t(labels[name] ?? name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ')), name]),
  );

/** Exchanges keys and values. */
const swapped = (table: Readonly<Record<string, string>>): Record<string, string> =>
  Object.fromEntries(Object.entries(table).map(([key, value]) => [value, key]));

/** Values of a state that the menu shows. */
const valuesOf = ({ technique, view, quality, budget, aa, decals, particles, rectangles, time }: ViewerState) => ({
  ...{ technique, view, quality, budget, aa, decals, particles, rectangles },
  stopped: time !== null,
});

/** The menu at the top right, made from the registries of techniques, views and scenes. */
export class ViewerMenu {
  readonly statistics = new StatisticsPanel();

  private readonly gui = new GUI({ title: 'Farol' });
  private readonly parameters: GUI;
  /** Values that the controllers are bound to. */
  private readonly values: ReturnType<typeof valuesOf>;
  private readonly effectValues: Record<string, unknown> = {};
  private readonly effectControllers = new Map<string, Controller>();
  /** Scene or model whose parameters are in the menu. */
  private scene = '';
  private parameterValues: Record<string, unknown> = {};

  private readonly stopFollowing: () => void;

  /** @param onLanguage - called with the language that the user chose; the host then makes a new menu */
  constructor(
    private readonly viewer: Viewer,
    onLanguage: (language: Language) => void,
  ) {
    const { gui } = this;
    this.values = valuesOf(viewer.state);
    const addChoice = (
      name: 'technique' | 'view' | 'quality' | 'budget' | 'aa',
      label: string,
      choices: Readonly<Record<string, string>>,
      choose: (value: string) => void,
    ): Controller => gui.add(this.values, name, choices).name(label).onChange(choose);
    const names = Object.fromEntries(Object.entries(techniques).map(([key, { label }]) => [t(label), key]));
    const methods = Object.fromEntries(known.antialiasing.map((name) => [labelOf(name), name]));
    const qualities = labelled(known.qualities, { auto: 'Automatic' });
    const budgets = labelled(known.budgets, { auto: 'On touch screens', off: 'Off ## budget' });
    addChoice('technique', t('Technique'), names, (name) => viewer.chooseTechnique(name));
    addChoice('view', t('View'), labelled(known.views), (name) => viewer.chooseView(name));
    addChoice('quality', t('Quality'), qualities, (name) => viewer.setQuality(name));
    addChoice('budget', t('Frame budget'), budgets, (name) => viewer.setBudget(name)).domElement.title = t(
      'Whether slow frames are drawn smaller and enlarged.',
    );
    addChoice('aa', t('Anti-aliasing'), methods, (name) => viewer.setAntialiasing(name));
    for (const [name, field] of Object.entries(known.effects)) {
      this.effectValues[name] = field.default;
      const controller = this.addField(gui, this.effectValues, name, field)!;
      this.effectControllers.set(
        name,
        controller.onChange((value: FieldValue) => viewer.setEffect(name, value)),
      );
    }
    gui
      .add(this.values, 'decals')
      .name(t(effectEntries.decals.label))
      .onChange((on: boolean) => viewer.setDecals(on)).domElement.title = t(
      'Decals thrown on the scene; they need a technique with a G-buffer.',
    );
    gui
      .add(this.values, 'particles', 0, 20_000, 100)
      .name(t('Particles'))
      .onFinishChange((count: number) => viewer.setParticles(count)).domElement.title = t(
      'Particles in the scene, each of them a light of 0.5 m.',
    );
    gui
      .add(this.values, 'rectangles', 0, 2000, 10)
      .name(t('Rectangle lights'))
      .onFinishChange((count: number) => viewer.setRectangles(count)).domElement.title = t(
      'Lights that shine from rectangles in the scene, each up to 1.5 m.',
    );
    gui
      .add(this.values, 'stopped')
      .name(t('Stop time'))
      .onChange(() => viewer.toggleTime());

    gui.add({ measure: () => void viewer.measure() }, 'measure').name(t('Measure this scene')).domElement.title = t(
      'Opens it in the Lab: how long each technique takes for it on this machine.',
    );

    gui.add({ language: textLanguage() }, 'language', swapped(languages)).name(t('Language')).onChange(onLanguage);

    const buttons = gui.addFolder(t('Scenes'));
    for (const [name, { label, help }] of Object.entries(scenes)) {
      buttons.add({ show: () => void viewer.chooseScene(name).catch(ignore) }, 'show').name(t(label)).domElement.title =
        t(help);
    }
    const models = gui.addFolder(t('Models'));
    this.addChooser(
      models,
      'files',
      t('Open a model…'),
      t('A .glb, .gltf, .obj, .stl, .ply or .zip, chosen together with the files that it names.'),
    );
    this.addChooser(models, 'folder', t('Open a folder…'), t('A folder with a model in it, and with what that names.'));
    this.parameters = gui.addFolder(t('Lights and sizes'));
    const figures = gui.addFolder(t('Last frame'));
    figures.$children.append(this.statistics.element);
    const apps = gui.addFolder('Farol').close();
    for (const [app, label] of [
      ['editor', t('Editor')],
      ['lab', t('Lab')],
      ['gallery', t('Gallery of examples')],
    ]) {
      const open = (): void =>
        void openBeside(app, label).catch(({ message }: Error) => viewer.messages.show('app', message));
      apps.add({ open }, 'open').name(label);
    }

    // an open menu would cover most of the picture on a phone, in either orientation
    if (innerWidth < 600 || (innerHeight < 600 && matchMedia('(pointer: coarse)').matches)) gui.close();
    this.stopFollowing = viewer.onChange(() => this.refresh());
    this.refresh();
  }

  /** Removes the menu from the page. */
  remove(): void {
    this.stopFollowing();
    this.gui.destroy();
  }

  /** Updates the menu from the viewer's state. */
  refresh(): void {
    const { state, modelName } = this.viewer;
    Object.assign(this.values, valuesOf(state));
    this.gui.show(state.gui);
    for (const [name, { default: otherwise }] of Object.entries(known.effects)) {
      this.effectValues[name] = state.effects[name] ?? otherwise;
    }
    for (const [name, controller] of this.effectControllers) {
      controller.show(isFieldVisible(known.effects, name, (field) => this.effectValues[field]));
    }

    const title = modelName ?? state.scene;
    const fields = modelName ? modelParameters : (scenes[state.scene]?.parameters ?? {});
    if (title !== this.scene) {
      this.scene = title;
      this.gui.title(`Farol: ${modelName ?? t(scenes[state.scene]?.label ?? '')}`);
      for (const controller of [...this.parameters.controllers]) controller.destroy();
      this.parameterValues = {};
      for (const [name, field] of Object.entries(fields)) this.addParameter(name, field);
    }
    for (const name of Object.keys(this.parameterValues)) {
      this.parameterValues[name] = state.parameters[name] ?? (fields as Record<string, Field>)[name].default;
    }
    for (const controller of this.gui.controllersRecursive()) controller.updateDisplay();
  }

  private addChooser(folder: GUI, what: 'files' | 'folder', label: string, help: string): void {
    const open = (): void => {
      void chooseFiles(what).then((files) => files && this.viewer.loadFiles(files));
    };
    folder.add({ open }, 'open').name(label).domElement.title = help;
  }

  private addParameter(name: string, field: Field): void {
    const { parameterValues: values } = this;
    values[name] = this.viewer.state.parameters[name] ?? field.default;
    const controller = this.addField(this.parameters, values, name, field);
    if (controller === null) delete values[name]; // no control for this type: only the address sets the parameter
    controller?.onFinishChange((value: number | string | boolean) => {
      void this.viewer.setParameters({ [name]: value }).catch(ignore);
    });
  }

  /** Adds a controller for a field. @returns the controller; null for a kind of field without one */
  private addField(folder: GUI, values: Record<string, unknown>, name: string, field: Field): Controller | null {
    let controller: Controller;
    if (field.kind === 'number') {
      const { min, max, step = field.integer ? 1 : undefined } = field;
      // no slider for a huge range, such as that of a seed
      const slides = min !== undefined && max !== undefined && max - min <= 100_000;
      controller = folder.add(values as Record<string, number>, name, min, slides ? max : undefined, step);
    } else if (field.kind === 'choice') {
      controller = folder.add(values, name, [...field.options]);
    } else if (field.kind === 'boolean' || field.kind === 'string') {
      controller = folder.add(values, name);
    } else if (field.kind === 'asset') {
      controller = folder.add(values, name, this.viewer.assets.list(field.assetType));
    } else return null; // no control for this kind of field: only the address sets it
    controller.domElement.title = t(field.help);
    return controller.name(labelOfField(name, field));
  }
}
