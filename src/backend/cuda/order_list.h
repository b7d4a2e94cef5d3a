/* The kernels that sort particles and build neighbour rows (order.h): ORDER(name) is expanded for each. */
ORDER(keys)
ORDER(starts)
ORDER(permute)
ORDER(row_counts)
ORDER(row_lengths)
ORDER(rows)
ORDER(hand_back)
