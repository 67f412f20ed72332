import { type CommandStack, Signal } from '@farol/editing';
import {
  type GameObject,
  Light,
  LightGroup,
  ParticleEmitter,
  type Scene,
  type SceneChange,
  soloLights,
} from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';
import type { EditorDocument } from '../EditorDocument';
import { CostEstimate, type CostView } from './lightCost';
import { hueOf, keyOfGroup, keyOfName, sortByKey } from './lightOrder';
import { colourOf, kindLabel, kindOf, type LightSource, shownNumber } from './lightSource';

/** A column of the table, by which its rows can be sorted. */
export type LightColumn = 'on' | 'solo' | 'name' | 'kind' | 'colour' | 'intensity' | 'range' | 'shadow' | 'cost';

/** Conditions, all of which a light must meet to be shown in the table. */
export interface LightFilter {
  /** Words that must each be in the name, the kind or the group's name. */
  readonly text: string;
  /** Kind of light, see `kindOf`; null for all. */
  readonly kind: string | null;
  /** Id of a group's object, '' for lights without a group; null for all. */
  readonly group: string | null;
  /** Whether only selected objects are shown. */
  readonly isSelected: boolean;
}

/** A row: a light, a group with its dimmer, or the heading above the lights without a group. */
export type LightRow =
  | { readonly kind: 'light'; readonly id: string; readonly object: GameObject; readonly source: LightSource }
  | {
      readonly kind: 'group';
      readonly id: string;
      readonly object: GameObject;
      readonly group: LightGroup;
      /** Number of the group's lights that pass the filter. */
      readonly count: number;
    }
  | { readonly kind: 'rest'; readonly id: ''; readonly count: number };

interface Entry {
  readonly source: LightSource;
  readonly row: LightRow;
  readonly name: string;
  /** Name in lower case, with numbers padded so that they sort by value. */
  readonly nameKey: string;
  /** Kind of the light and id of its group's object, see `kindOf`. */
  readonly kind: string;
  readonly group: string | null;
  /** Name and kind in lower case, for the search. */
  readonly words: string;
}

/** Parts of the table that can be out of date; an outdated part makes all later ones outdated. */
const parts = ['lights', 'order', 'filter', 'no'] as const;
type Part = (typeof parts)[number];

const isBefore = (a: Part, b: Part): boolean => parts.indexOf(a) < parts.indexOf(b);

/** Fields that decide which rows there are and in which group; changing one makes the rows anew. */
const structural = new Set(['group', 'type', 'shine', 'attenuation']);

/** Fields of lights and groups that do not affect the cost. */
const costless = new Set(['intensity', 'lightIntensity', 'diffuse', 'colourBy', 'kelvin', 'dimmer', 'colour']);

const noFilter: LightFilter = { text: '', kind: null, group: null, isSelected: false };

/**
 * The lights of a document as rows: filtered, sorted, in their groups; and the lights that are shown alone. Rows are
 * made when they are read after a change; their order is frozen while a value is being dragged.
 */
export class LightTable {
  /** Emits when rows or their values may have changed, once for all changes of a task. */
  readonly changed = new Signal();
  /** Emits with `changed` when rows may have been added, removed or moved, or the lights shown alone changed. */
  readonly arranged = new Signal();
  /** Number of times that the rows were made. */
  evaluations = 0;
  /** Column by which lights are sorted within their group. */
  sort: { readonly column: LightColumn; readonly isDescending: boolean } = { column: 'name', isDescending: false };

  private entries: Entry[] = [];
  /** The entries, sorted. */
  private ordered: readonly Entry[] = [];
  private made: readonly LightRow[] = [];
  private members: ReadonlyMap<string, readonly LightSource[]> = new Map();
  private filter = noFilter;
  private readonly folded = new Set<string>();
  private solo: ReadonlySet<string> = new Set();
  /** First outdated part. */
  private stale: Part = 'lights';
  /** Signals to be emitted at the end of the task. */
  private toTell: 'nothing' | 'values' | 'rows' = 'nothing';
  /** Shares of the lighting time by id of a light and by id of a group; key of what they were estimated for. */
  private costs: ReadonlyMap<string, number> = new Map();
  private readonly groupCosts = new Map<string, number>();
  private costKey = '';
  /** Number of changes of the scene that may have changed costs. */
  private costChanges = 0;
  private estimate: { readonly entries: readonly Entry[]; readonly run: CostEstimate } | null = null;

  constructor(private readonly document: EditorDocument) {}

  /** Subscribes to the document. @returns a function that unsubscribes, and shows all lights again */
  connect(): () => void {
    const { document } = this;
    const { commands, selection, simulation } = document;
    const endings = [
      document.structure.subscribe(() => this.tell('lights')),
      document.opened.subscribe(() => {
        this.solo = new Set();
        this.costChanges++;
        this.tell('lights');
      }),
      document.sceneChanged.subscribe((change) => this.follow(change)),
      commands.changed.subscribe(() => this.stale !== 'no' && this.tell('order')),
      selection.changed.subscribe(() => this.tell(this.filter.isSelected ? 'filter' : 'no')),
      simulation.changed.subscribe(() => simulation.state !== 'stopped' && this.endSolo()),
    ];
    this.tell('lights');
    return () => {
      this.endSolo();
      for (const end of endings) end();
    };
  }

  /** Rows in display order; the same array until something changes. */
  get rows(): readonly LightRow[] {
    if (this.stale === 'no' || (this.stale !== 'lights' && this.commands.isGestureOpen)) return this.made;
    if (this.stale === 'lights') this.entries = this.collect();
    const { column, isDescending } = this.sort;
    if (this.stale !== 'filter')
      this.ordered = sortByKey(
        this.entries,
        (entry) => this.keyOf(entry, column),
        ({ nameKey }) => nameKey,
        isDescending,
      );
    this.stale = 'no';
    this.evaluations++;
    this.made = this.arrange();
    return this.made;
  }

  /** Number of lights in the scene. */
  get size(): number {
    return this.entries.length;
  }

  /** Groups of the scene, by name. */
  get groups(): readonly LightGroup[] {
    return sortByKey(this.scene.componentsOf(LightGroup), nameKeyOf, nameKeyOf, false);
  }

  /** Whether lights are shown below their groups. */
  get isGrouped(): boolean {
    return this.scene.componentsOf(LightGroup).length > 0;
  }

  get shownFilter(): LightFilter {
    return this.filter;
  }

  setFilter(change: Partial<LightFilter>): void {
    this.filter = { ...this.filter, ...change };
    this.tell('filter');
  }

  /** Sorts by a column; reverses the order when it is sorted by that column already. */
  sortBy(column: LightColumn): void {
    this.sort = { column, isDescending: this.sort.column === column && !this.sort.isDescending };
    this.tell('order');
  }

  isFolded(group: string): boolean {
    return this.folded.has(group);
  }

  fold(group: string, isFolded: boolean): void {
    if (isFolded) this.folded.add(group);
    else this.folded.delete(group);
    this.tell('filter');
  }

  /** Share of the lighting time, 0 to 1, of a light, or of a group's lights that pass the filter, as last estimated. */
  costOf({ kind, id }: LightRow): number {
    return kind === 'light' ? (this.costs.get(id) ?? 0) : this.groupCost(id);
  }

  private groupCost(group: string): number {
    let cost = this.groupCosts.get(group);
    if (cost === undefined) {
      cost = 0;
      for (const { id } of this.membersOf(group)) cost += this.costs.get(id) ?? 0;
      this.groupCosts.set(group, cost);
    }
    return cost;
  }

  /** Estimates the costs for a view, a thousand lights per call; begins anew when the view or scene has changed. */
  measure(view: CostView): void {
    const { camera, width, height } = view;
    if (!this.estimate) {
      const key = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements, width, height].join();
      const state = `${key} ${this.costChanges} ${this.scene.time}`;
      if (state === this.costKey || this.stale === 'lights') return;
      this.costKey = state;
      const { entries } = this;
      this.estimate = {
        entries,
        run: new CostEstimate(
          entries.map(({ source }) => source),
          view,
        ),
      };
    }
    const { entries, run } = this.estimate;
    const costs = run.next();
    if (!costs) return;
    this.estimate = null;
    this.groupCosts.clear();
    this.costs = new Map(entries.map(({ row }, i) => [row.id, costs[i]]));
    this.tell(this.sort.column === 'cost' ? 'order' : 'no');
  }

  /** Whether some lights are shown alone. */
  get hasSolo(): boolean {
    return this.solo.size > 0;
  }

  /** Whether all of these lights are among those shown alone. */
  areSolo(sources: readonly LightSource[]): boolean {
    return sources.length > 0 && sources.every(({ id }) => this.solo.has(id));
  }

  /** Adds lights to those that are shown alone (solo), or removes them. A preview: neither an edit nor saved. */
  setSolo(sources: readonly LightSource[], isSolo: boolean): void {
    const next = new Set(this.solo);
    for (const { id } of sources) {
      if (isSolo) next.add(id);
      else next.delete(id);
    }
    this.showAlone(next);
  }

  /** Shows all lights again. */
  endSolo(): void {
    if (this.hasSolo) this.showAlone(new Set());
  }

  /** Components that an edit of a row changes: those of all selected rows if it is selected, else its own. */
  editedBy<T extends LightSource | LightGroup>(edited: T): readonly T[] {
    const { selection } = this.document;
    if (!selection.has(edited.gameObject.id)) return [edited];
    const selected = new Set(selection.ids);
    const all = edited instanceof LightGroup ? this.groups : this.entries.map(({ source }) => source);
    return (all as readonly T[]).filter(({ gameObject }) => selected.has(gameObject.id));
  }

  /** Lights of a group that pass the filter. */
  membersOf(group: string): readonly LightSource[] {
    return this.members.get(group) ?? [];
  }

  /** Lights of selected objects, and of selected groups. */
  get selected(): readonly LightSource[] {
    const selected = new Set(this.document.selection.ids);
    return this.entries.flatMap(({ source }) =>
      selected.has(source.gameObject.id) || selected.has(source.group ?? '') ? [source] : [],
    );
  }

  private get scene(): Scene {
    return this.document.scene;
  }

  private get commands(): CommandStack {
    return this.document.commands;
  }

  private showAlone(ids: ReadonlySet<string>): void {
    this.solo = ids;
    soloLights(this.scene, ids.size > 0 ? ids : null);
    this.tell('order');
  }

  private follow(change: SceneChange): void {
    if (change.kind !== 'field' || !costless.has(change.field)) this.costChanges++;
    if (change.kind === 'enabled') this.tellOf(change.component, this.sort.column === 'on');
    else if (change.kind === 'field') {
      const { component, field } = change;
      if (structural.has(field)) return this.tellOf(component, true, 'lights');
      this.tellOf(component, this.sort.column !== 'name' && this.sort.column !== 'cost');
    }
  }

  private tellOf(owner: FieldOwner, isOrder: boolean, part: Part = 'order'): void {
    if (isLight(owner) || owner instanceof LightGroup) this.tell(isOrder ? part : 'no');
  }

  private tell(part: Part): void {
    if (isBefore(part, this.stale)) this.stale = part;
    const isFirst = this.toTell === 'nothing';
    // rows are not sorted again while a value is being dragged
    const isRows = part === 'lights' || (part !== 'no' && !this.commands.isGestureOpen);
    if (isFirst || isRows) this.toTell = isRows ? 'rows' : 'values';
    if (isFirst) queueMicrotask(() => this.emit());
  }

  private emit(): void {
    const told = this.toTell;
    this.toTell = 'nothing';
    if (told === 'rows') this.arranged.emit();
    this.changed.emit();
  }

  private collect(): Entry[] {
    const before = new Map(this.entries.map((entry) => [entry.source, entry]));
    const emitters = this.scene.componentsOf(ParticleEmitter).filter(({ shine }) => shine);
    return [...this.scene.componentsOf(Light), ...emitters].map((source) => {
      const { gameObject: object, id } = source;
      const { name } = object;
      const { group } = source;
      const kind = kindOf(source);
      const known = before.get(source);
      if (known?.name === name && known.kind === kind && known.group === group) return known;
      const row: LightRow = known?.row ?? { kind: 'light', id, object, source };
      const words = `${name} ${kindLabel(kind)}`.toLowerCase();
      return { source, row, name, nameKey: keyOfName(name), kind, group, words };
    });
  }

  private arrange(): LightRow[] {
    const { groups } = this;
    const passing = this.ordered.filter(this.filterOf(groups));
    if (groups.length === 0) return passing.map(({ row }) => row);
    const lists = new Map<string, Entry[]>(
      [...groups.map(({ gameObject }) => gameObject.id), ''].map((id) => [id, []]),
    );
    for (const entry of passing) (lists.get(entry.group ?? '') ?? lists.get('')!).push(entry);
    this.groupCosts.clear();
    this.members = new Map([...lists].map(([id, entries]) => [id, entries.map(({ source }) => source)]));
    const isWhole = this.filter.text === '' && this.filter.kind === null && !this.filter.isSelected;
    const { column, isDescending } = this.sort;
    const keyOf = (group: LightGroup) => keyOfGroup(group, column, () => this.groupCost(group.gameObject.id));
    const rows = sortByKey(groups, keyOf, nameKeyOf, isDescending).flatMap((group): LightRow[] => {
      const {
        gameObject: object,
        gameObject: { id },
      } = group;
      const members = lists.get(id)!;
      const isAsked = this.filter.group === null || this.filter.group === id;
      if (members.length === 0 && !(isWhole && isAsked)) return [];
      const head: LightRow = { kind: 'group', id, object, group, count: members.length };
      return this.folded.has(id) ? [head] : [head, ...members.map(({ row }) => row)];
    });
    const rest = lists.get('')!.map(({ row }) => row);
    if (rest.length === 0) return rows;
    const head: LightRow = { kind: 'rest', id: '', count: rest.length };
    return this.folded.has('') ? [...rows, head] : [...rows, head, ...rest];
  }

  private filterOf(groups: readonly LightGroup[]): (entry: Entry) => boolean {
    const { text, kind, group, isSelected } = this.filter;
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    const names = new Map(groups.map(({ gameObject: { id, name } }) => [id, name.toLowerCase()]));
    const selected = new Set(isSelected ? this.document.selection.ids : []);
    return (entry) => {
      if (kind !== null && entry.kind !== kind) return false;
      const name = entry.group === null ? undefined : names.get(entry.group);
      if (group !== null && (name === undefined ? '' : entry.group) !== group) return false;
      if (isSelected && !selected.has(entry.source.gameObject.id)) return false;
      return words.every((word) => entry.words.includes(word) || name?.includes(word) === true);
    };
  }

  private keyOf({ source, row, nameKey, kind }: Entry, column: LightColumn): number | string {
    if (column === 'name') return nameKey;
    if (column === 'kind') return kindLabel(kind);
    if (column === 'on') return Number(!source.isActive);
    if (column === 'solo') return Number(!this.solo.has(row.id));
    if (column === 'cost') return -this.costOf(row);
    if (column === 'colour') return hueOf(colourOf(source) ?? [0, 0, 0]);
    if (column === 'shadow') return Number(source instanceof Light && source.castShadow);
    const value = shownNumber(source, column)?.value;
    return column === 'range' ? value || Infinity : value!;
  }
}

const nameKeyOf = ({ gameObject }: LightGroup): string => keyOfName(gameObject.name);

const isLight = (owner: FieldOwner): owner is LightSource => owner instanceof Light || owner instanceof ParticleEmitter;
