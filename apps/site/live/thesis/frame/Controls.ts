/** A control's entry in the address (`&name=value`), its label, and what a change does. */
interface Entry<V> {
  readonly name: string;
  readonly label: string;
  readonly value: V;
  change(value: V): void;
}

export interface RangeEntry extends Entry<number> {
  readonly min: number;
  readonly max: number;
  /** Smallest change of the slider. Default 1. */
  readonly step?: number;
  /** Text shown for a value. Default: the number. */
  format?(value: number): string;
}

export interface ChoiceEntry<V extends string> extends Entry<V> {
  /** Values with their labels. */
  readonly options: readonly (readonly [value: V, label: string])[];
}

/**
 * Controls of a figure in plain HTML. A control begins with the value that the address has for its name, else with its
 * own `value`; `change` is called once with it, then after each change by the reader, before the figure is drawn.
 */
export class Controls {
  readonly element = document.createElement('div');
  /** Controls that are to be hidden once they are made. */
  private readonly hidden = new Map<string, boolean>();
  private readonly query = new URLSearchParams(location.search);

  /** @param changed - called after each change */
  constructor(private readonly changed: () => void) {
    this.element.className = 'controls';
  }

  /** @returns function that sets the slider */
  range({ name, label, value, min, max, step = 1, format = String, change }: RangeEntry): (value: number) => void {
    const input = document.createElement('input');
    Object.assign(input, { type: 'range', name, min: String(min), max: String(max), step: String(step) });
    const output = document.createElement('output');
    const set = (next: number): void => {
      input.value = String(next);
      output.textContent = format(input.valueAsNumber);
      change(input.valueAsNumber);
    };
    input.addEventListener('input', () => {
      set(input.valueAsNumber);
      this.changed();
    });
    this.add(label, input, output);
    const asked = this.query.get(name);
    set(asked === null || Number.isNaN(Number(asked)) ? value : Number(asked));
    return set;
  }

  check({ name, label, value, change }: Entry<boolean>): void {
    const input = document.createElement('input');
    Object.assign(input, { type: 'checkbox', name, checked: (this.query.get(name) ?? String(value)) === 'true' });
    input.addEventListener('change', () => {
      change(input.checked);
      this.changed();
    });
    const words = this.add('', input);
    words.append(label);
    change(input.checked);
  }

  /**
   * A row of buttons of which one is pressed, or a menu for more than eight.
   * @returns function that chooses
   */
  choice<V extends string>({ name, label, options, value, change }: ChoiceEntry<V>): (value: V) => void {
    const asked = this.query.get(name) as V | null;
    const first = asked !== null && options.some(([one]) => one === asked) ? asked : value;
    const chosen = (next: V): void => {
      change(next);
      this.changed();
    };
    const show = options.length > 8 ? this.menu(name, label, options, chosen) : this.row(name, label, options, chosen);
    show(first);
    change(first);
    return (next) => {
      show(next);
      change(next);
    };
  }

  /** Hides a slider or checkbox that means nothing for what is shown, or shows it again. */
  hide(name: string, isHidden: boolean): void {
    const label = this.element.querySelector<HTMLElement>(`label:has([name="${name}"])`);
    if (label !== null) label.hidden = isHidden;
    else this.hidden.set(name, isHidden);
  }

  button(name: string, label: string, press: () => void): HTMLButtonElement {
    const button = document.createElement('button');
    Object.assign(button, { type: 'button', name, textContent: label });
    button.addEventListener('click', () => {
      press();
      this.changed();
    });
    this.element.append(button);
    return button;
  }

  private add(label: string, ...parts: HTMLElement[]): HTMLLabelElement {
    const words = document.createElement('label');
    words.append(label, ...parts);
    words.hidden = this.hidden.get((parts[0] as HTMLInputElement).name) ?? false;
    this.element.append(words);
    return words;
  }

  private menu<V extends string>(
    name: string,
    label: string,
    options: ChoiceEntry<V>['options'],
    chosen: (value: V) => void,
  ): (value: V) => void {
    const select = document.createElement('select');
    select.name = name;
    select.append(...options.map(([value, text]) => new Option(text, value)));
    select.addEventListener('change', () => chosen(select.value as V));
    this.add(label, select);
    return (value) => void (select.value = value);
  }

  private row<V extends string>(
    name: string,
    label: string,
    options: ChoiceEntry<V>['options'],
    chosen: (value: V) => void,
  ): (value: V) => void {
    const group = document.createElement('fieldset');
    if (label === '') group.setAttribute('aria-label', name);
    else group.append(Object.assign(document.createElement('legend'), { textContent: label }));
    const inputs = new Map<V, HTMLInputElement>();
    for (const [value, text] of options) {
      const input = document.createElement('input');
      Object.assign(input, { type: 'radio', name, value });
      input.addEventListener('change', () => chosen(value));
      const words = document.createElement('label');
      words.append(input, text);
      group.append(words);
      inputs.set(value, input);
    }
    this.element.append(group);
    return (value) => void (inputs.get(value)!.checked = true);
  }
}
