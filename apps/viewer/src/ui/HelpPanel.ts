import { t } from '@farol/editing';
import type { Field } from '@farol/engine/fields';
import type { KnownNames } from '../state/ViewerState';

const keys = (): [string, string][] => [
  [t('W A S D, arrows'), t('fly forward, left, back, right; with Shift faster')],
  ['E, Q', t('rise, sink')],
  [t('Drag##pointer'), t('look round')],
  [t('Touch'), t('orbit with one finger, zoom and pan with two')],
  [t('Space'), t('stop and go')],
  ['H', t('show or hide the menu')],
  ['?', t('this help')],
  [t('Drop a .glb, .gltf, .obj, .stl, .ply, folder or .zip'), t('show that model')],
];

/** The help over the picture: keys, and all parameters of the address. Opened by its button, F1 or `?`. */
export class HelpPanel {
  private readonly dialog = element('dialog', { className: 'help', ariaLabel: t('Help'), tabIndex: -1 });
  private readonly button = element('button', { type: 'button', className: 'help-button', textContent: '?' });

  constructor(parent: HTMLElement, known: KnownNames) {
    const { button } = this;
    button.title = t('Keys and address parameters (?)');
    button.ariaLabel = t('Help');
    button.addEventListener('click', () => this.toggle());

    const close = element('button', { type: 'button', textContent: t('Close') });
    close.addEventListener('click', () => this.dialog.close());
    const href = 'https://github.com/farol-renderer/farol/tree/main/apps/site/live/gallery';
    const textContent = t('Examples for your own page');
    this.dialog.append(
      element('h2', { textContent: t('Keys') }),
      table(keys()),
      element('h2', { textContent: t('Address') }),
      table(addressHelp(known).map(([name, text]) => [`?${name}=`, text])),
      close,
      element('a', { href, textContent, target: '_blank', rel: 'noopener noreferrer' }),
    );
    parent.append(button, this.dialog);
  }

  /** Removes the button and the help from the page. */
  remove(): void {
    this.button.remove();
    this.dialog.remove();
  }

  toggle(): void {
    if (this.dialog.open) return this.dialog.close();
    this.dialog.showModal();
    // the browser focused the first button, at the end of the panel, and scrolled there
    this.dialog.focus();
    this.dialog.scrollTop = 0;
  }
}

/** Lists all parameters of the address with explanations, including those of the scenes. */
export function addressHelp({
  scenes,
  techniques,
  views,
  qualities,
  antialiasing,
  effects,
}: KnownNames): [string, string][] {
  const parameters = new Map<string, { help: string; range: string; scenes: string[] }>();
  for (const [scene, definition] of Object.entries(scenes)) {
    for (const [name, field] of Object.entries(definition.parameters)) {
      const entry = parameters.get(name) ?? { help: field.help, range: allowed(field), scenes: [] };
      entry.scenes.push(scene);
      parameters.set(name, entry);
    }
  }
  return [
    ['scene', Object.keys(scenes).join(', ')],
    ['technique', techniques.join(', ')],
    ['view', views.join(', ')],
    [
      'quality',
      t('Bytes of surfaces and shadows: {names}; auto is lite on phones and weak devices.', {
        names: qualities.join(', '),
      }),
    ],
    ...[...parameters].map(([name, { help, range, scenes: of }]): [string, string] => {
      return [name, `${t(help)} ${range}(${of.join(', ')})`];
    }),
    [
      'aa',
      t('Anti-aliasing: {names}. TAA gathers over frames: at a fixed time each draw is one.', {
        names: antialiasing.join(', '),
      }),
    ],
    ...Object.entries(effects).map(([name, field]): [string, string] => [
      name,
      field.kind === 'boolean'
        ? `${t('1 or 0.')} ${t(field.label!)}: ${t(field.help)}`
        : `${t(field.help)} ${allowed(field)}`.trim(),
    ]),
    ['decals', t('1 throws decals on the scene, with techniques that have a G-buffer.')],
    ['particles', t('So many particles in the scene, each of them a light of 0.5 m. 0 to 200000.')],
    ['rectangles', t('So many rectangle lights in the scene, each up to 1.5 m. 0 to 20000.')],
    ['time', t('Draws the scene once, as it is at this time (s), and does not move it.')],
    ['width, height', t('Size of the picture (CSS pixels); the window by default.')],
    ['dpr', t('Device pixels for each CSS pixel; those of the screen by default, 2 at most.')],
    ['budget', t('Whether slow frames are drawn smaller and enlarged: auto (on touch screens), on or off.')],
    ['gui', t('0 hides the menu.')],
  ];
}

function allowed(field: Field): string {
  if (field.kind === 'choice') return `${field.options.join(', ')}. `;
  if (field.kind !== 'number') return '';
  if (field.min !== undefined && field.max !== undefined)
    return `${t('{min} to {max}.', { min: field.min, max: field.max })} `;
  return field.min !== undefined ? `${t('{min} or more.', { min: field.min })} ` : '';
}

/** A new element with these properties. */
const element = <K extends keyof HTMLElementTagNameMap>(name: K, properties: Partial<HTMLElementTagNameMap[K]>) =>
  Object.assign(document.createElement(name), properties);

function table(rows: readonly (readonly [string, string])[]): HTMLElement {
  const list = document.createElement('dl');
  for (const [term, text] of rows)
    list.append(element('dt', { textContent: term }), element('dd', { textContent: text }));
  return list;
}
