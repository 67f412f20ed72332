import type { Texts } from '@farol/editing';

/** Spanish texts of errors in typed numbers. */
export const numbers: Texts = {
  'There is one “)” too many.': 'Sobra un «)».',
  'Between “{before}” and “{after}” a sign such as + is missing.':
    'Entre «{before}» y «{after}» falta un signo, por ejemplo +.',
  'What is added has to be in units of one kind.': 'Lo que se suma tiene que estar en unidades de la misma clase.',
  'A number cannot be divided by 0.': 'No se puede dividir entre 0.',
  'A power is of numbers without units.': 'Una potencia es de números sin unidad.',
  'A number is missing.': 'Falta un número.',
  'Something is missing after “{text}”.': 'Falta algo después de «{text}».',
  'A number cannot begin with “{text}”.': 'Un número no puede empezar por «{text}».',
  'Between “{before}” and “{after}” a number is missing.': 'Entre «{before}» y «{after}» falta un número.',
  'After “{text}” a bracket is missing: {text}(…).': 'Después de «{text}» falta un paréntesis: {text}(…).',
  '“{text}” is of a number without a unit.': '«{text}» es de un número sin unidad.',
  'A “)” is missing.': 'Falta un «)».',
  'Before “{text}” a “)” is missing.': 'Antes de «{text}» falta un «)».',
  'Before “{text}” a sign such as + is missing.': 'Antes de «{text}» falta un signo, por ejemplo +.',
  'Before “{text}” a number is missing.': 'Antes de «{text}» falta un número.',
  '“{text}” is neither a unit nor a function.': '«{text}» no es ni una unidad ni una función.',
  'There are too many brackets.': 'Hay demasiados paréntesis.',
  '“{text}” has no place in a number.': '«{text}» no cabe en un número.',
  '“{text}” has two decimal points.': '«{text}» tiene dos separadores decimales.',
  '“{text}” may be {large} or {small}: write one of them.':
    '«{text}» puede ser {large} o {small}: hay que escribir uno de los dos.',
  'This number has no unit: leave the unit out.': 'Este número no tiene unidad: hay que quitarla.',
  'The unit does not fit: this number is in {unit}.': 'La unidad no encaja: este número va en {unit}.',
  'This is too long for a number.': 'Es demasiado largo para un número.',
  'A factor has no unit: leave the unit out.': 'Un factor no tiene unidad: hay que quitarla.',
  'To change a number by a part of it, write *= and a factor, such as *=1.1.':
    'Para cambiar un número en una parte, se escribe *= y un factor, por ejemplo *=1.1.',
  'There is no such number.': 'No existe tal número.',
  'This is larger than a number can be.': 'Es mayor de lo que puede ser un número.',
  'It must be at most {max}{unit}.': 'Debe ser como mucho {max}{unit}.',
  'It must be at least {min}{unit}.': 'Debe ser al menos {min}{unit}.',
  'It must be from {min} to {max}{unit}.': 'Debe estar entre {min} y {max}{unit}.',
};
