import { t } from '@farol/editing';
import type { Object3D } from 'three';
import type { Session } from '../model/Session';
import { element } from '../ui/element';
import { icon } from '../ui/icon';
import { objectIcon } from '../ui/objectIcon';

const ROW = 22; // CSS pixels, equal to style.css
const MARGIN = 4; // rows drawn above and below the visible ones
const MANY = { 'aria-multiselectable': true };

interface Row {
  object: Object3D;
  depth: number;
  /** Position among the siblings, from 1. */
  place: number;
  siblings: number;
}

/**
 * The objects of the scene as a tree. Only visible rows have elements; changes by the page appear at the next
 * `refresh`. Arrow keys move, open and close as in any tree; Ctrl selects several objects, Shift a range of rows.
 *
 * @see https://www.w3.org/WAI/ARIA/apg/patterns/treeview/
 */
export class Tree {
  readonly element = element('div', {
    className: 'tree',
    role: 'tree',
    'aria-label': t('Hierarchy'),
    tabIndex: 0,
    ...MANY,
  });
  /** Filter text: objects whose name or type contains it are listed. */
  readonly search = element('input', { type: 'search', placeholder: t('Search'), 'aria-label': t('Search objects') });
  private readonly spacer = element('div', { className: 'spacer', role: 'presentation' });
  private readonly open = new Set<Object3D>();
  private rows: Row[] = [];
  /** Elements of the visible rows, by the id of their object. */
  private readonly elements = new Map<number, HTMLElement>();
  private drawn = '';
  /** Object at which a selection with Shift begins. */
  private anchor: Object3D | null = null;
  private readonly end: () => void;
  private readonly sizes: ResizeObserver;

  constructor(private readonly session: Session) {
    this.open.add(session.scene);
    this.element.append(this.spacer);
    this.search.addEventListener('input', () => this.reveal());
    this.element.addEventListener('scroll', () => this.draw());
    this.element.addEventListener('click', (event) => this.click(event));
    this.element.addEventListener('keydown', (event) => {
      if (this.key(event)) event.preventDefault();
    });
    this.end = session.selection.changed.subscribe(() => this.reveal());
    this.sizes = new ResizeObserver(() => this.draw());
    this.sizes.observe(this.element);
    this.refresh();
  }

  /** Updates the rows from the scene. */
  refresh(): void {
    this.rows = this.search.value === '' ? this.openRows() : this.foundRows(this.search.value.toLowerCase());
    this.spacer.style.height = `${this.rows.length * ROW}px`;
    this.draw();
  }

  /** Rows of the scene and of the children of expanded objects. */
  private openRows(): Row[] {
    const rows: Row[] = [];
    const add = (object: Object3D, depth: number, place: number, siblings: number) => {
      rows.push({ object, depth, place, siblings });
      if (!this.open.has(object)) return;
      const { children } = object;
      for (let i = 0; i < children.length; i++) add(children[i], depth + 1, i + 1, children.length);
    };
    add(this.session.scene, 0, 1, 1);
    return rows;
  }

  /** All objects whose name or type contains a text, as a flat list. */
  private foundRows(text: string): Row[] {
    const found: Object3D[] = [];
    this.session.scene.traverse((object) => {
      if (object.name.toLowerCase().includes(text) || object.type.toLowerCase().includes(text)) found.push(object);
    });
    return found.map((object, i) => ({ object, depth: 0, place: i + 1, siblings: found.length }));
  }

  dispose(): void {
    this.end();
    this.sizes.disconnect();
  }

  /** Updates the rows, expands the selected object's ancestors, and scrolls to the object. */
  private reveal(): void {
    const { primary: selected } = this.session.selection;
    for (let each = selected?.parent ?? null; each; each = each.parent) this.open.add(each);
    this.refresh();
    const index = this.rows.findIndex(({ object }) => object === selected);
    if (index < 0) return;
    const { scrollTop, clientHeight } = this.element;
    if (index * ROW < scrollTop) this.element.scrollTop = index * ROW;
    else if ((index + 1) * ROW > scrollTop + clientHeight) this.element.scrollTop = (index + 1) * ROW - clientHeight;
    this.draw();
  }

  private draw(): void {
    const { scrollTop, clientHeight } = this.element;
    const first = Math.max(0, Math.floor(scrollTop / ROW) - MARGIN);
    const rows = this.rows.slice(first, Math.ceil((scrollTop + clientHeight) / ROW) + MARGIN);
    const { primary: selected, items: selection } = this.session.selection;
    const chosen = selection.map(({ id }) => id).join();
    const drawn = rows
      .map(({ object, depth }) =>
        [object.id, object.name, depth, object.visible, object.children.length > 0, this.open.has(object)].join(),
      )
      .join(';');
    if (`${drawn} ${first} ${chosen}` === this.drawn) return;
    this.drawn = `${drawn} ${first} ${chosen}`;
    this.drawRows(rows, first);
    const isSeen = selected && rows.some(({ object }) => object === selected);
    if (isSeen) this.element.setAttribute('aria-activedescendant', `object-${selected.id}`);
    else this.element.removeAttribute('aria-activedescendant');
  }

  /**
   * Draws the visible rows. An object's element is reused while its row is visible: replacing an element while it is
   * pressed would lose the click.
   */
  private drawRows(rows: readonly Row[], first: number): void {
    const seen = new Set(rows.map(({ object }) => object.id));
    const selection = new Set(this.session.selection.items);
    for (const [id, each] of this.elements) {
      if (seen.has(id)) continue;
      each.remove();
      this.elements.delete(id);
    }
    let last: Element | null = null;
    rows.forEach((row, i) => {
      const { id } = row.object;
      let drawn = this.elements.get(id);
      if (!drawn) this.elements.set(id, (drawn = this.makeRow(id)));
      this.drawRow(drawn, row, first + i, selection.has(row.object));
      if (drawn.previousElementSibling !== last || !drawn.parentNode)
        this.spacer.insertBefore(drawn, last ? last.nextSibling : this.spacer.firstChild);
      last = drawn;
    });
  }

  private makeRow(id: number): HTMLElement {
    return element(
      'div',
      { role: 'treeitem', id: `object-${id}` },
      element('span', { className: 'twist', 'aria-hidden': true }),
      element('span', { className: 'kind' }),
      element('span', { className: 'name' }),
      element('span', { className: 'type' }),
    );
  }

  private drawRow(row: HTMLElement, item: Row, index: number, isSelected: boolean): void {
    const { object, depth, place, siblings } = item;
    const hasChildren = object.children.length > 0;
    const isOpen = this.open.has(object);
    row.className = object.visible ? 'row' : 'row hidden';
    row.ariaLevel = String(depth + 1);
    row.ariaPosInSet = String(place);
    row.ariaSetSize = String(siblings);
    row.ariaSelected = String(isSelected);
    row.ariaExpanded = hasChildren ? String(isOpen) : null;
    row.style.top = `${index * ROW}px`;
    row.style.paddingLeft = `${6 + 12 * depth}px`;
    row.dataset.index = String(index);
    const [twist, kind, name, type] = row.children as unknown as HTMLElement[];
    if (twist.childElementCount === 0) twist.append(icon('chevron', 10));
    twist.dataset.open = String(isOpen);
    twist.style.visibility = hasChildren ? '' : 'hidden';
    const wanted = objectIcon(object);
    if (kind.dataset.icon !== wanted) {
      kind.dataset.icon = wanted;
      kind.replaceChildren(icon(wanted, 14));
    }
    setText(name, object.name || object.type);
    setText(type, object.name ? object.type : '');
  }

  private click(event: MouseEvent): void {
    const target = event.target as HTMLElement;
    const row = this.rows[Number(target.closest<HTMLElement>('.row')?.dataset.index ?? -1)];
    if (!row) return;
    if (target.closest('.twist') && row.object.children.length > 0) this.toggle(row.object);
    else this.choose(row.object, event);
  }

  /**
   * Changes the selection by a click on a row.
   * @param keys - modifiers held: Ctrl toggles one object, Shift selects all rows from the anchor
   */
  private choose(object: Object3D, { ctrlKey, metaKey, shiftKey }: MouseEvent | KeyboardEvent): void {
    const { rows, session, anchor } = this;
    const objects = rows.map((row) => row.object);
    const range = shiftKey ? rangeOf(objects, anchor, object) : null;
    if (range) {
      session.selection.set(range);
      return;
    }
    this.anchor = object;
    if (ctrlKey || metaKey) session.selection.toggle(object);
    else session.select(object);
  }

  private toggle(object: Object3D): void {
    if (!this.open.delete(object)) this.open.add(object);
    this.refresh();
  }

  /** Handles a key of the tree. @returns whether the tree has handled the key */
  private key(event: KeyboardEvent): boolean {
    const { rows, session } = this;
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const at = rows.findIndex(({ object }) => object === session.selection.primary);
    const select = (index: number) => {
      const row = rows[Math.min(rows.length - 1, Math.max(0, index))];
      this.choose(row.object, event);
    };
    const object = rows[at]?.object;
    switch (event.key) {
      case 'ArrowDown':
        select(at + 1);
        return true;
      case 'ArrowUp':
        select(at - 1);
        return true;
      case 'Home':
        select(0);
        return true;
      case 'End':
        select(rows.length - 1);
        return true;
      case 'ArrowRight':
        if (object && object.children.length > 0 && !this.open.has(object)) this.toggle(object);
        else if (object && this.open.has(object)) select(at + 1);
        return true;
      case 'ArrowLeft':
        if (object && this.open.has(object) && object.children.length > 0) this.toggle(object);
        else if (object?.parent && object !== session.scene) session.select(object.parent);
        return true;
      case 'Escape':
        session.select(null);
        return true;
      default:
        return false;
    }
  }
}

function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/**
 * Items of a list from `from` to `to`, both included, and in this order, since the last item of a selection is the
 * primary one. Null when the list lacks `from` or `to`.
 */
export function rangeOf<Item>(items: readonly Item[], from: Item | null, to: Item): Item[] | null {
  const [first, last] = [items.findIndex((each) => each === from), items.indexOf(to)];
  if (first < 0 || last < 0) return null;
  const range = items.slice(Math.min(first, last), Math.max(first, last) + 1);
  return first < last ? range : range.toReversed();
}
