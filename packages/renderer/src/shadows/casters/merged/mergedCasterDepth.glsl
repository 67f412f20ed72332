// Writes nothing but depth.
// Farol
//# main
;
