export { Farol } from './Farol';
export { useFarol } from './useFarol';
export type { FarolProps } from './useFarolSettings';
